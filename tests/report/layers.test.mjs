// SPDX-License-Identifier: MIT
// Beside the path stand the travel of the machine where it is asked for, the workpieces, and the
// origins of work systems.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ask, drawn, openReport, placeOfRow, startBrowser } from './support/browser.mjs';
import { readReport } from './support/decode.mjs';
import { difference, readPng } from './support/pixels.mjs';
import { edited } from './support/reports.mjs';

const kQuiet = [84, 92, 102]; // Colour of the travel on a light page.
const kBrown = [140, 100, 40]; // Of workpieces.
const kAxisX = [213, 94, 0];
const kTravel = { x: [-60, 400], y: [-80, 150], z: [-100, 50] };
let browser;
before(async () => { browser = await startBrowser(); });
after(() => browser.close());

/** Gives the runs of a report a travel, and no origins. */
function withTravel(travel) {
  return ({ runs }) => runs.forEach((run) => {
    delete run.origins;
    for (const limit of run.axis_limits) {
      [limit.min_mm, limit.max_mm] = travel[limit.axis] ?? [null, null];
    }
  });
}

/** Returns how millimetres seen from above become pixels of the page. */
async function mapOf(page, file) {
  const { period_s: period, setpoints } = readReport(file).report.runs[0];
  const rows = Array.from({ length: 9 }, (_, k) => Math.round((k + 1) * setpoints / 10));
  const at = [];
  for (const row of rows) {
    at.push({ ...await ask(page, 'positionAt', row * period), seen: await placeOfRow(page, row) });
  }
  const low = at.reduce((a, b) => (b.x < a.x ? b : a)), high = at.reduce((a, b) => (b.x > a.x ? b : a));
  const scale = (high.seen.x - low.seen.x) / (high.x - low.x);
  return {
    scale,
    x: (mm) => low.seen.x + scale * (mm - low.x),
    y: (mm) => low.seen.y - scale * (mm - low.y),
  };
}

/** Returns which part of the places from `from` to `to` has the colour within a pixel of it. */
function partOf(image, from, to, colour) {
  const many = 60;
  let same = 0;
  for (let k = 0; k < many; k++) {
    const [x, y] = [0, 1].map((i) => from[i] + (to[i] - from[i]) * (k + 0.5) / many);
    const near = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => image.colour(x + dx, y + dy)));
    if (near.some((found) => difference(found, colour) < 60)) same++;
  }
  return same / many;
}

async function layer(page, name) {
  await page.locator('summary', { hasText: 'Layers' }).click();
  await page.getByLabel(name).click();
  await page.keyboard.press('Escape');
  await drawn(page);
}

test('the travel is drawn where it is asked for, and only then a fit shows it', async () => {
  const file = edited('butterfly', 'travel', withTravel(kTravel));
  const page = await openReport(browser, file);
  await page.keyboard.press('2');
  await drawn(page);
  const without = await mapOf(page, file);
  await layer(page, 'Travel of the machine');
  const map = await mapOf(page, file);
  const [left, right] = kTravel.x.map(map.x), [bottom, top] = kTravel.y.map(map.y);
  const image = readPng(await page.screenshot());
  for (const [from, to] of [[[left, bottom], [right, bottom]], [[left, top], [right, top]],
    [[left, bottom], [left, top]], [[right, bottom], [right, top]]]) {
    const part = partOf(image, from, to, kQuiet);
    assert.ok(part > 0.6, `${part} of a side is drawn`);
  }
  assert.ok(map.scale < 0.5 * without.scale);
  await layer(page, 'Travel of the machine');
  assert.ok(Math.abs((await mapOf(page, file)).scale - without.scale) < 1e-3);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

test('a path that leaves its travel shows it, and one axis alone has none', async () => {
  for (const [as, travel, there, on] of [
    ['left', { x: [-60, 20], y: [-80, null] }, 1, true],
    ['line', { x: [-60, 20] }, 0],
  ]) {
    const page = await openReport(browser, edited('butterfly', `travel_${as}`, withTravel(travel)));
    const menu = page.locator('summary', { hasText: 'Layers' });
    assert.equal(await menu.count(), there, as);
    if (there) {
      await menu.click();
      assert.equal(await page.getByLabel('Travel of the machine').isChecked(), on);
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  }
});

/** Returns the edges of a box. */
function edgesOfBox(low, high) {
  const corner = (k) => [0, 1, 2].map((axis) => (k & (1 << axis) ? high : low)[axis]);
  return [...Array(8).keys()].flatMap((k) => [1, 2, 4].filter((bit) => !(k & bit))
    .flatMap((bit) => [...corner(k), ...corner(k | bit)]));
}

test('workpieces and origins are drawn until they are switched off', async () => {
  const low = [-20, -15, -10], high = [130, 90, 0], origin = [120, 0, 0];
  const file = edited('butterfly', 'workpiece', ({ runs }) => {
    runs[0].workpieces = [{ name: 'plate <b>', line: 5, edges_mm: edgesOfBox(low, high) }];
    runs[0].origins = [{ name: 'G54', at_mm: origin }, { name: 'G55', at_mm: origin }];
  });
  const page = await openReport(browser, file);
  await page.keyboard.press('2');
  await drawn(page);
  const seen = async () => {
    const map = await mapOf(page, file);
    const image = readPng(await page.screenshot());
    const [left, right] = [low[0], high[0]].map(map.x), [bottom, top] = [low[1], high[1]].map(map.y);
    const [x, y] = [map.x(origin[0]), map.y(origin[1])];
    return {
      sides: [partOf(image, [left, bottom], [right, bottom], kBrown),
        partOf(image, [right, bottom], [right, top], kBrown)],
      axis: partOf(image, [x + 3, y], [x + 15, y], kAxisX),
    };
  };
  const shown = await seen();
  assert.ok(shown.sides.every((part) => part > 0.9), `${shown.sides}`);
  assert.ok(shown.axis > 0.9, `${shown.axis} of an axis is drawn`);
  await layer(page, 'Work systems');
  assert.ok((await seen()).axis < 0.1);
  await layer(page, 'Workpiece');
  assert.ok((await seen()).sides.every((part) => part < 0.1));
  await page.locator('summary', { hasText: 'Layers' }).click();
  await page.getByRole('button', { name: 'plate <b>, line 5' }).click();
  assert.equal((await ask(page, 'selected')).line, 5);
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});
