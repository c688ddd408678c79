// SPDX-License-Identifier: MIT
// All of the page is reached by the keyboard.
import assert from 'node:assert/strict';
import { after, before, beforeEach, afterEach, test } from 'node:test';
import { ask, drawn, kPath, openReport, placeOfRow, startBrowser } from './support/browser.mjs';
import { readReport } from './support/decode.mjs';
import { report } from './support/reports.mjs';

let browser, page;
before(async () => { browser = await startBrowser(); });
after(() => browser.close());
beforeEach(async () => { page = await openReport(browser, report('loops')); });
afterEach(async () => {
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

async function press(...keys) {
  for (const key of keys) await page.keyboard.press(key);
  await drawn(page);
}

/** Returns the value of the player's slider. */
const playedTo = () => page.locator('input[type=range]').evaluate((slider) => Number(slider.value));

test('keys step through the lines that lose most time', async () => {
  const chords = await openReport(browser, report('chords'));
  const worst = readReport(report('chords')).report.runs[0].worst_lines.map(({ line }) => line);
  assert.ok(worst.length > 1);
  for (const [key, line] of [['n', worst[0]], ['n', worst[1]], ['p', worst[0]], ['Escape']]) {
    await chords.keyboard.press(key);
    await drawn(chords);
    assert.equal((await ask(chords, 'selected'))?.line, line);
  }
  assert.deepEqual(chords.trouble, []);
  await chords.context().close();
});

test('keys step from line to line in time, and through time', async () => {
  await press('.', '.');
  const second = await ask(page, 'selected');
  await press('.');
  assert.notDeepEqual(await ask(page, 'selected'), second);
  await press(',');
  assert.deepEqual(await ask(page, 'selected'), second);
  const from = await playedTo();
  await press('ArrowRight', 'ArrowRight');
  assert.ok(await playedTo() > from);
});

test('Space plays and pauses', async () => {
  await press(' ');
  await page.waitForTimeout(400);
  const moving = await playedTo();
  assert.ok(moving > 0);
  await press(' ');
  const paused = await playedTo();
  await page.waitForTimeout(300);
  assert.equal(await playedTo(), paused);
});

test('arrows choose lines of the listing', async () => {
  await ask(page, 'show', 'program');
  await drawn(page);
  await page.getByLabel('Lines of the program').first().focus();
  await press('Home', 'ArrowDown', 'ArrowDown');
  assert.equal((await ask(page, 'selected')).line, 3);
  await press('End');
  assert.equal((await ask(page, 'selected')).line, (await ask(page, 'runs'))[0].lines);
});

test('keys move, zoom and fit the picture of the path', async () => {
  await press('2');
  await page.locator(kPath).focus();
  await press('0');
  const first = await placeOfRow(page, 100), other = await placeOfRow(page, 900);
  await press('ArrowRight');
  const moved = await placeOfRow(page, 100);
  assert.ok(Math.abs(first.x - moved.x - 40) < 0.5 && Math.abs(first.y - moved.y) < 0.5);
  await press('+');
  const a = await placeOfRow(page, 100), b = await placeOfRow(page, 900);
  const grown = Math.hypot(a.x - b.x, a.y - b.y) / Math.hypot(first.x - other.x, first.y - other.y);
  assert.ok(Math.abs(grown - 1.25) < 0.01, `grown by ${grown}`);
  await press('0');
  const fitted = await placeOfRow(page, 100);
  assert.ok(Math.hypot(fitted.x - first.x, fitted.y - first.y) < 0.5);
});

test('keys turn the path in space', async () => {
  await press('3');
  await page.locator(kPath).focus();
  const before = await placeOfRow(page, 100);
  await press('ArrowLeft', 'ArrowUp');
  const turned = await placeOfRow(page, 100);
  assert.ok(Math.hypot(turned.x - before.x, turned.y - before.y) > 3);
});

test('keys look at the path from its sides, and a turn leaves them', async () => {
  const menu = page.getByLabel('Look at the path from');
  const { period_s: period, setpoints } = readReport(report('loops')).report.runs[0];
  const rows = Array.from({ length: 12 }, (_, k) => Math.round((k + 1) * setpoints / 13));
  const places = () => Promise.all(rows.map((row) => placeOfRow(page, row)));
  const at = await Promise.all(rows.map((row) => ask(page, 'positionAt', row * period)));
  for (const [key, side, right, up] of [['T', 'top', 'x', 'y'], ['F', 'front', 'x', 'z'],
    ['R', 'right', 'y', 'z']]) {
    await press(key);
    assert.equal(await menu.inputValue(), side);
    const seen = await places();
    const scale = scaleOf(seen, at, right);
    seen.forEach(({ x, y }, k) => {
      const off = Math.hypot(x - seen[0].x - scale * (at[k][right] - at[0][right]),
        y - seen[0].y + scale * (at[k][up] - at[0][up]));
      assert.ok(off < 0.1, `${side}: ${off} px`);
    });
  }
  await press('I');
  assert.equal(await menu.inputValue(), 'isometric');
  await page.locator(kPath).focus();
  await press('ArrowLeft');
  assert.equal(await menu.inputValue(), '');
  await menu.selectOption('front');
  assert.equal(await page.getByRole('button', { name: '3-D' }).getAttribute('aria-pressed'), 'true');
  await press('2');
  assert.equal(await menu.inputValue(), '');
});

/** Returns the pixels per mm along an axis that lies in the screen. */
function scaleOf(seen, at, axis) {
  const spread = (values) => Math.max(...values) - Math.min(...values);
  return spread(seen.map(({ x }) => x)) / spread(at.map((place) => place[axis]));
}

test('keys change colours, theme and panel', async () => {
  const menu = page.getByLabel('Colour the path by');
  const first = await menu.inputValue();
  await press('c');
  assert.notEqual(await menu.inputValue(), first);
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await background();
  await press('t');
  assert.notEqual(await background(), light);
  const selected = () => page.getByRole('tab', { selected: true }).innerText();
  const panel = await selected();
  await press(']');
  assert.notEqual(await selected(), panel);
  await press('[');
  assert.equal(await selected(), panel);
});

test('a key lists the keys', async () => {
  await press('?');
  const dialog = page.getByRole('dialog');
  assert.ok(await dialog.isVisible());
  assert.match(await dialog.innerText(), /play or pause/);
  assert.match(await dialog.innerText(), /T F R I\s+path in space from the top/);
  await press('Escape');
  assert.ok(!await dialog.isVisible());
});

test('Tab reaches every control, and each has a name and a visible focus', async () => {
  await page.evaluate(() => document.activeElement?.blur());
  const seen = new Map();
  for (let k = 0; k < 60; k++) {
    await page.keyboard.press('Tab');
    const found = await page.evaluate(() => {
      const at = document.activeElement;
      if (!at || at === document.body) return null;
      const style = getComputedStyle(at);
      const key = (at.dataset.focusKey ??= String(Math.random()));
      return {
        key, tag: at.tagName,
        name: at.getAttribute('aria-label') || at.title || at.innerText ||
          at.closest('label')?.innerText || at.labels?.[0]?.innerText || '',
        focus: style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) > 0 ||
          style.boxShadow !== 'none',
      };
    });
    if (found) seen.set(found.key, found);
  }
  const all = [...seen.values()];
  assert.ok(all.length >= 12, `${all.length} controls`);
  assert.deepEqual(all.filter(({ name }) => !name.trim()), []);
  assert.deepEqual(all.filter(({ focus }) => !focus), []);
  assert.ok(all.some(({ name }) => name.startsWith('Path of the tool')));
});
