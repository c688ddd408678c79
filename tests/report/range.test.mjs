// SPDX-License-Identifier: MIT
// A range of lines is shown alone: in the path, in the charts and as a sum, until all are shown again.
import assert from 'node:assert/strict';
import { after, afterEach, before, beforeEach, test } from 'node:test';
import { ask, drawn, openReport, placeOfRow, startBrowser } from './support/browser.mjs';
import { decode, readReport, stretchesOf } from './support/decode.mjs';
import { difference, readPng } from './support/pixels.mjs';
import { report } from './support/reports.mjs';

const kPaper = [255, 255, 255];
let browser, page, data, run;
before(async () => {
  browser = await startBrowser();
  data = readReport(report('loops'));
  [run] = data.report.runs;
});
after(() => browser.close());
beforeEach(async () => {
  page = await openReport(browser, report('loops'), { height: 1000 }); // all lines are seen
  await ask(page, 'show', 'program');
  await drawn(page);
});
afterEach(async () => {
  assert.deepEqual(page.trouble, []);
  await page.context().close();
});

/** Returns the lines of the program that move, ascending. */
function movingLines() {
  const [files, lines] = ['file', 'line'].map((name) => decode(data.blob, run.spans[name]));
  return [...new Set(lines.filter((line, i) => line > 0 && files[i] === 0))].sort((a, b) => a - b);
}

/** Returns the stretches of lines in rows, in the order of time. */
function stretches(first, last) {
  return movingLines().filter((line) => line >= first && line <= last)
    .flatMap((line) => stretchesOf(data, line)).sort((a, b) => a.from - b.from);
}

const clickLine = (line, ...modifiers) =>
  page.locator(`[data-line="${line}"] code`).click({ modifiers, position: { x: 3, y: 8 } });
const bar = () => page.getByRole('group', { name: 'Range of lines' });

/** Checks that the page shows these lines alone. */
async function isAlone(first, last) {
  await drawn(page);
  assert.deepEqual(await ask(page, 'lines'), { file: 0, first, last });
  const wanted = stretches(first, last);
  const zoom = await ask(page, 'zoom');
  assert.ok(Math.abs(zoom.from_s - wanted[0].from * run.period_s) < 1e-9);
  assert.ok(Math.abs(zoom.to_s - wanted.at(-1).to * run.period_s) < 1e-9);
  assert.equal(await page.locator('.line.within').count(), last - first + 1);
  assert.ok(await page.getByRole('button', { name: 'only line' }).isVisible());
}

/** Checks that the page shows all lines again. */
async function isAll() {
  await drawn(page);
  assert.equal(await ask(page, 'lines'), null);
  assert.equal(await ask(page, 'zoom'), null);
  assert.equal(await page.locator('.line.within').count(), 0);
  assert.equal(await page.getByRole('button', { name: 'only line' }).count(), 0);
}

test('Shift and click shows lines alone, with the sum of their times; Escape shows all', async () => {
  const lines = movingLines();
  const [first, last] = [lines[1], lines.at(-2)];
  await clickLine(last);
  await clickLine(first, 'Shift');
  await isAlone(first, last);
  assert.equal(await ask(page, 'selected'), null);
  const [of, ms] = ['line', 'ms'].map((name) => decode(data.blob, run.lines[name]));
  const seconds = ms.reduce((sum, value, i) => sum + (of[i] >= first && of[i] <= last ? value : 0), 0) / 1e3;
  const text = (await bar().innerText()).replace(/\s/g, '');
  const shown = /^Lines–(?:(\d+)min)?([\d.]+)s,[\d.]+m?s?lost,[\d.]+m+All$/.exec(text);
  assert.ok(shown, text);
  assert.ok(Math.abs(60 * Number(shown[1] ?? 0) + Number(shown[2]) - seconds) < 0.1, `${text}: ${seconds} s`);
  await page.keyboard.press('Escape');
  await isAll();
});

test('only the path of these lines is drawn, and a rapid before them is not', async () => {
  const butterfly = await openReport(browser, report('butterfly'));
  const other = readReport(report('butterfly'));
  const share = (line) => shareDrawn(butterfly, stretchesOf(other, line)[0]);
  await butterfly.keyboard.press('2');
  await drawn(butterfly);
  const before = [await share(5), await share(7)];
  await ask(butterfly, 'pickLines', 7, 7);
  await drawn(butterfly);
  const alone = [await share(5), await share(7)];
  assert.ok(before[0] > 0.4 && before[1] > 0.9, `${before}`);
  assert.ok(alone[0] < 0.2 && alone[1] > 0.9, `${alone}`);
  await butterfly.keyboard.press('Escape');
  await drawn(butterfly);
  assert.ok(await share(5) > 0.4);
  assert.deepEqual(butterfly.trouble, []);
  await butterfly.context().close();
});

/** Returns the part of a stretch at which the picture is not empty. */
async function shareDrawn(of, { from, to }) {
  const image = readPng(await of.screenshot());
  const many = 30;
  let found = 0;
  for (let k = 2; k < many - 2; k++) {
    const { x, y } = await placeOfRow(of, from + (to - from) * (k + 0.5) / many);
    const near = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => image.colour(x + dx, y + dy)));
    if (near.some((colour) => difference(colour, kPaper) > 60)) found++;
  }
  return found / (many - 4);
}

test('Shift and arrows extend the range, and a click elsewhere ends it', async () => {
  const lines = movingLines();
  await clickLine(lines[0]);
  await page.getByLabel('Lines of the program').first().focus();
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('Shift+ArrowDown');
  await isAlone(lines[0], lines[0] + 2);
  await page.keyboard.press('Shift+ArrowUp');
  await isAlone(lines[0], lines[0] + 1);
  const within = lines[0];
  await clickLine(within);
  assert.equal((await ask(page, 'selected')).line, within);
  assert.notEqual(await ask(page, 'lines'), null);
  await clickLine(lines.at(-1));
  await isAll();
});

test('a range is typed, and a button shows all again', async () => {
  const lines = movingLines();
  await page.getByLabel('First line that is shown').fill(String(lines[0]));
  const to = page.getByLabel('Last line that is shown');
  await to.fill('99999');
  await to.press('Enter');
  const count = (await ask(page, 'runs'))[0].lines;
  await drawn(page);
  assert.deepEqual(await ask(page, 'lines'), { file: 0, first: lines[0], last: count });
  assert.equal(await to.inputValue(), String(count));
  await bar().getByRole('button', { name: 'All' }).click();
  await isAll();
  await ask(page, 'pickLines', 1, 1);
  await drawn(page);
  assert.match(await bar().innerText(), /no motion/);
  assert.ok((await ask(page, 'frames')).vertices > 100, 'the path stays');
});

test('in a comparison each run shows its own stretches', async () => {
  const both = await openReport(browser, report('comparison'));
  await ask(both, 'pickLines', 7, 7);
  await drawn(both);
  const seen = [];
  for (const key of ['a', 'b']) {
    await both.keyboard.press(key);
    await drawn(both);
    seen.push(await ask(both, 'zoom'));
  }
  const other = readReport(report('comparison'));
  seen.forEach(({ from_s, to_s }, k) => {
    const wanted = stretchesOf(other, 7, { run: k });
    const { period_s: period } = other.report.runs[k];
    assert.ok(Math.abs(from_s - wanted[0].from * period) < 1e-9);
    assert.ok(Math.abs(to_s - wanted.at(-1).to * period) < 1e-9);
  });
  assert.deepEqual(both.trouble, []);
  await both.context().close();
});
