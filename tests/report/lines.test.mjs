// SPDX-License-Identifier: MIT
// A line of the listing and its stretch of the path belong together, both ways.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { ask, drawn, openReport, placeOfRow, startBrowser } from './support/browser.mjs';
import { decode, readReport, readTrace, stretchesOf } from './support/decode.mjs';
import { nearestDifference, readPng } from './support/pixels.mjs';
import { report, trace } from './support/reports.mjs';

const kPlunge = 5; // Line of the chords that is not seen from above.
const kLit = [255, 45, 155]; // Colour of what is lit on a light page.
let browser;
before(async () => { browser = await startBrowser(); });
after(() => browser.close());

/** Clicks a line of the listing, which is scrolled to it by the keyboard. */
async function clickLine(page, line) {
  await page.getByRole('tab', { name: 'Program' }).click();
  const search = page.getByRole('searchbox');
  await search.fill(String(line > 1 ? line - 1 : line + 1));
  await search.press('Enter');
  await drawn(page);
  await page.locator(`[data-line="${line}"]`).click();
  await drawn(page);
}

/** Returns times of the first and last period of each stretch of a line in a CSV trace. */
function stretchesInTrace(rows, line) {
  const found = [];
  rows.forEach((row, i) => {
    if (row.line !== line) return;
    if (i > 0 && rows[i - 1].line === line) found.at(-1).to = row.t_s;
    else found.push({ from: i > 0 ? rows[i - 1].t_s : row.t_s, to: row.t_s });
  });
  return found;
}

/** Returns lines of a program that move: first, last, and some between. */
function someLines(data, wanted) {
  const lines = [...new Set(decode(data.blob, data.report.runs[0].spans.line))]
    .sort((a, b) => a - b);
  const step = Math.max(1, Math.floor(lines.length / wanted));
  return lines.filter((_, k) => k % step === 0);
}

for (const name of ['butterfly', 'loops', 'chords']) {
  describe(name, () => {
    let page, data, rows, period;
    before(async () => {
      page = await openReport(browser, report(name));
      data = readReport(report(name));
      rows = readTrace(trace(name));
      period = data.report.runs[0].period_s;
    });

    test('a click on a line lights its stretches', async () => {
      for (const line of someLines(data, 8)) {
        await clickLine(page, line);
        assert.equal((await ask(page, 'selected'))?.line, line);
        const lit = await ask(page, 'ranges');
        const wanted = stretchesOf(data, line);
        assert.deepEqual(lit.map(({ from_s, to_s }) => [from_s, to_s]),
          wanted.map(({ from, to }) => [from * period, to * period]), `line ${line}`);
        const inTrace = stretchesInTrace(rows, line).filter(({ from, to }) => to > from);
        assert.equal(lit.length, inTrace.length, `stretches of line ${line} in the trace`);
        lit.forEach(({ from_s, to_s }, k) => {
          assert.ok(Math.abs(from_s - inTrace[k].from) <= 1.01 * period &&
            Math.abs(to_s - inTrace[k].to) <= 1.01 * period,
          `line ${line}: ${from_s} to ${to_s}, in the trace ${JSON.stringify(inTrace[k])}`);
        });
      }
    });

    test('what is lit is drawn where the trace has the line', async () => {
      const line = longestLine(rows);
      const [stretch] = stretchesOf(data, line);
      await page.keyboard.press(name === 'loops' ? '3' : '2'); // its holes are seen from aside
      await zoomTo(page, stretch);
      await page.keyboard.press('Escape');
      await drawn(page);
      const before = await countLit(page, stretch);
      // The tool's marker, of the same colour, may stand on a part of it.
      assert.ok(before <= 9, `${before} of 19 places of line ${line} are lit before`);
      await ask(page, 'pick', line);
      await drawn(page);
      const lit = await countLit(page, stretch);
      assert.ok(lit >= 17, `${lit} of 19 places of line ${line} are lit`);
    });

    test('positions are those of the trace', async () => {
      for (const part of [0.1, 0.37, 0.5, 0.81, 0.99]) {
        const row = rows[Math.floor(part * (rows.length - 1))];
        const shown = await ask(page, 'positionAt', row.t_s);
        const off = Math.hypot(shown.x - row.x_mm, shown.y - row.y_mm, shown.z - row.z_mm);
        assert.ok(off < 0.0025, `${off} mm at ${row.t_s} s`);
      }
    });

    test('feeds and speeds at the nodes are those of the trace', () => {
      const { blob, report: { runs: [run] } } = data;
      const [at, feed, v] = ['row', 'feed', 'v'].map((column) => decode(blob, run.nodes[column]));
      const byRow = new Map(rows.map((row) => [Math.round(row.t_s / period), row]));
      let compared = 0;
      at.forEach((row, i) => {
        const traced = byRow.get(row);
        if (traced === undefined) return;
        assert.ok(Math.abs(v[i] - traced.v_mm_s) <= run.error_mm_s + 1e-3,
          `${v[i]} instead of ${traced.v_mm_s} mm/s in row ${row}`);
        if (feed[i] > 0 && traced.feed_mm_s > 0) {
          assert.ok(Math.abs(feed[i] - traced.feed_mm_s) < 1e-3, `feed ${feed[i]} in row ${row}`);
          compared++;
        }
      });
      assert.ok(compared > 50, `${compared} of ${at.length} nodes`);
    });

    test('a click on the path chooses its line', async () => {
      await page.getByRole('button', { name: '2-D' }).click();
      await page.keyboard.press('Escape');
      await drawn(page);
      let clicked = 0;
      for (const part of [0.13, 0.29, 0.44, 0.62, 0.77, 0.9]) {
        const row = rows[Math.floor(part * (rows.length - 1))];
        if (!(row.v_mm_s > 0)) continue;
        const { x, y } = await placeOfRow(page, row.t_s / period);
        await page.mouse.click(x, y);
        await drawn(page);
        const chosen = await ask(page, 'selected');
        const near = linesNear(rows, row, await pixelSize(page, row, period));
        assert.ok(near.has(chosen?.line), `line ${chosen?.line} instead of ${[...near]}`);
        clicked++;
      }
      assert.ok(clicked >= 4, `${clicked} places were clicked`);
      assert.deepEqual(page.trouble, []);
    });
  });
}

/** Zooms the picture by the wheel until a stretch is at least 80 px from end to end. */
async function zoomTo(page, { from, to }) {
  const middle = (from + to) / 2;
  for (let k = 0; k < 60; k++) {
    const places = [];
    for (let j = 0; j <= 8; j++) places.push(await placeOfRow(page, from + (to - from) * j / 8));
    const far = Math.max(...places.map(({ x, y }) => Math.hypot(x - places[0].x, y - places[0].y)));
    if (far > 80) break;
    const { x, y } = await placeOfRow(page, middle);
    await page.mouse.move(x, y);
    await page.mouse.wheel(0, -200);
    await drawn(page);
  }
  await page.mouse.move(5, 5);
}

/** Returns how many of 19 places of a stretch have the colour of what is lit. */
async function countLit(page, { from, to }) {
  const image = readPng(await page.screenshot());
  let lit = 0;
  for (let k = 1; k < 20; k++) {
    const { x, y } = await placeOfRow(page, from + (to - from) * k / 20);
    if (nearestDifference(image, x, y, kLit) < 30) lit++;
  }
  return lit;
}

/** Returns the cutting line that is longest. */
function longestLine(rows) {
  const lengths = new Map();
  rows.forEach((row, i) => {
    const before = rows[i - 1];
    if (!(row.feed_mm_s > 0) || before?.line !== row.line || row.line === kPlunge) return;
    const step = Math.hypot(row.x_mm - before.x_mm, row.y_mm - before.y_mm,
      row.z_mm - before.z_mm);
    lengths.set(row.line, (lengths.get(row.line) ?? 0) + step);
  });
  return [...lengths].reduce((best, next) => (next[1] > best[1] ? next : best))[0];
}

/** Returns how many mm a CSS pixel is, from two places of the path. */
async function pixelSize(page, row, period) {
  const at = row.t_s / period;
  const [a, b] = [await placeOfRow(page, 0.2 * at), await placeOfRow(page, at)];
  const [p, q] = [await ask(page, 'positionAt', 0.2 * row.t_s), await ask(page, 'positionAt', row.t_s)];
  return Math.hypot(p.x - q.x, p.y - q.y) / Math.max(1e-9, Math.hypot(a.x - b.x, a.y - b.y));
}

/** Returns the lines that pass within two pixels of a place as seen from above. */
function linesNear(rows, { x_mm: x, y_mm: y }, pixel) {
  const near = new Set();
  for (const row of rows) {
    if (Math.hypot(row.x_mm - x, row.y_mm - y) <= 2 * pixel + 0.05) near.add(row.line);
  }
  return near;
}
