// SPDX-License-Identifier: MIT
// The path has the colours of its legend, at places whose values the trace knows.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ask, drawn, openReport, placeOfRow, startBrowser } from './support/browser.mjs';
import { readReport, readTrace } from './support/decode.mjs';
import { difference, nearestDifference, readPng } from './support/pixels.mjs';
import { report, trace } from './support/reports.mjs';

const kTolerance = 14; // Of 255: half of the largest step from pixel to pixel along the path.
let browser, rows, period;
before(async () => {
  browser = await startBrowser();
  rows = readTrace(trace('butterfly'));
  period = readReport(report('butterfly')).report.runs[0].period_s;
});
after(() => browser.close());

/** Returns the stops of the legend's ramp, left to right. */
async function rampOf(page) {
  const style = await page.locator('.ramp').evaluate((ramp) => getComputedStyle(ramp).backgroundImage);
  const stops = [...style.matchAll(/rgb\((\d+), (\d+), (\d+)\) ([\d.]+)%/g)]
    .map(([, r, g, b, at]) => ({ at: Number(at) / 100, colour: [r, g, b].map(Number) }));
  assert.ok(stops.length >= 2, style);
  return stops;
}

function colourAt(stops, part) {
  const next = Math.max(1, stops.findIndex(({ at }) => at >= part - 1e-9));
  const a = stops[next - 1], b = stops[next];
  const t = (part - a.at) / (b.at - a.at);
  return a.colour.map((value, k) => value + t * (b.colour[k] - value));
}

const ratioOf = ({ v_mm_s: v, feed_mm_s: feed }) => Math.min(1, v / feed);

/** Returns rows that cut, whose neighbours have nearly the same ratio of feeds. */
function steadyRows() {
  const reach = 6;
  return rows.filter((row, i) => {
    if (i < reach || i + reach >= rows.length || !(row.feed_mm_s > 0)) return false;
    const near = rows.slice(i - reach, i + reach + 1);
    return near.every((other) => other.feed_mm_s === row.feed_mm_s) &&
      Math.max(...near.map(ratioOf)) - Math.min(...near.map(ratioOf)) < 0.06;
  });
}

/** Returns for each tenth of the scale up to three steady rows. */
function rowsOverScale() {
  const found = Array.from({ length: 10 }, () => []);
  for (const row of steadyRows()) found[Math.min(9, Math.floor(10 * ratioOf(row)))].push(row);
  return found.flatMap((tenth) => [0.2, 0.5, 0.8].map((part) => tenth[Math.floor(part * tenth.length)]))
    .filter((row) => row !== undefined);
}

for (const dark of [false, true]) {
  test(`the ratio of feeds has the legend's colours on a ${dark ? 'dark' : 'light'} page`, async () => {
    const page = await openReport(browser, report('butterfly'), { dark, width: 1600, height: 1200 });
    await drawn(page);
    const stops = await rampOf(page);
    const image = readPng(await page.screenshot());
    const places = rowsOverScale();
    assert.ok(new Set(places.map((row) => Math.floor(5 * ratioOf(row)))).size >= 4,
      'the places cover the scale');
    const wrong = [];
    for (const row of places) {
      const wanted = colourAt(stops, ratioOf(row));
      const { x, y } = await placeOfRow(page, row.t_s / period);
      const off = nearestDifference(image, x, y, wanted, 2);
      if (off > kTolerance) wrong.push(`${ratioOf(row).toFixed(2)} at ${row.t_s} s: ${off} of 255`);
    }
    assert.ok(wrong.length <= places.length / 10, wrong.join('\n'));
    assert.ok(difference(colourAt(stops, 0.1), colourAt(stops, 1)) > 5 * kTolerance);
    await page.context().close();
  });
}

test('limits have the colours of the legend', async () => {
  const page = await openReport(browser, report('butterfly'), { width: 1600, height: 1200 });
  await ask(page, 'colourBy', 'limit');
  await drawn(page);
  const legend = await page.locator('.legend li').evaluateAll((entries) => entries.map((entry) => [
    entry.innerText.trim(),
    getComputedStyle(entry.querySelector('.swatch')).backgroundColor.match(/\d+/g).map(Number)]));
  const image = readPng(await page.screenshot());
  for (const [limit, name] of [['acceleration', 'acceleration'], ['feed', 'programmed feed']]) {
    const colour = legend.find(([text]) => text === name)?.[1];
    assert.ok(colour, `${name} is in the legend: ${JSON.stringify(legend)}`);
    const of = rows.filter((row, i) => row.feed_mm_s > 0 && i > 20 && i + 20 < rows.length &&
      rows.slice(i - 20, i + 20).every((other) => other.limit === limit));
    let same = 0;
    for (let k = 1; k <= 12; k++) {
      const { x, y } = await placeOfRow(page, of[Math.floor(of.length * k / 13)].t_s / period);
      if (nearestDifference(image, x, y, colour) <= kTolerance) same++;
    }
    assert.ok(same >= 11, `${same} of 12 places of ${limit} have its colour`);
  }
  await page.context().close();
});
