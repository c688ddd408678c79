// SPDX-License-Identifier: MIT
// The picture of a surface has the colours of its data, at their places.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { drawn, openReport, startBrowser } from './support/browser.mjs';
import { decode, readReport } from './support/decode.mjs';
import { difference, readPng } from './support/pixels.mjs';
import { report } from './support/reports.mjs';

const kMet = [86, 180, 233], kMissed = [213, 94, 0];
// Viridis at both ends and in the middle (van der Walt and Smith, 2015).
const kViridis = [[0, [68, 1, 84]], [0.5, [33, 145, 140]], [1, [253, 231, 37]]];
const kSurface = '[role=application][aria-label*="of the surface"]';
let browser, page, surface, rmax, target;
before(async () => {
  browser = await startBrowser();
  page = await openReport(browser, report('surface'), { width: 1600, height: 1100 });
  const data = readReport(report('surface'));
  ({ surface } = data.report.runs[0]);
  rmax = decode(data.blob, surface.rmax_um);
  target = decode(data.blob, surface.target_um);
  await page.getByRole('tab', { name: 'Surface' }).click();
  await drawn(page);
});
after(() => browser.close());

/** Shows one look; returns the colour near the middle of each region with a known roughness. */
async function coloursOf(look) {
  await page.getByRole('button', { name: look, exact: true }).click();
  await drawn(page);
  await page.mouse.move(5, 5);
  await drawn(page);
  const image = readPng(await page.screenshot());
  const regions = [...rmax.keys()].filter((k) => rmax[k] >= 0);
  const places = await page.evaluate(([selector, list]) => {
    const element = document.querySelector(selector);
    const box = element.getBoundingClientRect();
    return list.map(([x, y]) => {
      const [px, py] = element.placeOf(x, y);
      const beneath = document.elementFromPoint(box.left + px, box.top + py);
      return beneath === element ? [box.left + px, box.top + py] : null;
    });
  }, [kSurface, regions.map((k) => [
    surface.origin_mm[0] + (k % surface.region_columns + 0.5) * surface.region_mm,
    surface.origin_mm[1] + (Math.floor(k / surface.region_columns) + 0.5) * surface.region_mm])]);
  return regions.map((region, k) => ({
    region, colour: places[k] && image.colour(...places[k]),
  })).filter(({ colour }) => colour !== null);
}

test('regions that meet and that miss their target have their colours', async () => {
  const shown = await coloursOf('Target met');
  let judged = 0, right = 0;
  for (const { region, colour } of shown) {
    if (!(target[region] > 0)) continue;
    const isMet = rmax[region] <= target[region];
    const nearer = difference(colour, kMet) < difference(colour, kMissed);
    judged++;
    if (nearer === isMet) right++;
  }
  assert.ok(judged > 10, `${judged} regions were judged`);
  // The hatching of a missed region may pass through its middle.
  assert.ok(right >= 0.98 * judged, `${right} of ${judged} regions`);
});

test('the roughness has the colours of its scale', async () => {
  const shown = await coloursOf('Rmax');
  const most = Math.max(...rmax);
  let compared = 0;
  for (const [part, wanted] of kViridis) {
    const near = shown.filter(({ region }) => Math.abs(rmax[region] / most - part) < 0.015);
    if (near.length === 0) continue;
    const least = Math.min(...near.map(({ colour }) => difference(colour, wanted)));
    assert.ok(least < 20, `at ${part} of the scale: ${least} of 255`);
    compared++;
  }
  assert.ok(compared >= 1);
});

test('heights are shaded', async () => {
  await coloursOf('Height');
  const box = await page.locator(kSurface).boundingBox();
  const image = readPng(await page.screenshot());
  const colours = new Set();
  for (let k = 1; k < 40; k++) {
    for (let j = 1; j < 40; j++) {
      colours.add(image.colour(box.x + box.width * k / 40, box.y + box.height * j / 40).join());
    }
  }
  assert.ok(colours.size > 60, `${colours.size} colours`);
  assert.deepEqual(page.trouble, []);
});
