// SPDX-License-Identifier: MIT
// A comparison shows the times of both runs, as each of them has on its own.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ask, drawn, openReport, startBrowser } from './support/browser.mjs';
import { readReport } from './support/decode.mjs';
import { edited, report, timeOf } from './support/reports.mjs';

let browser, page, data;
before(async () => {
  browser = await startBrowser();
  page = await openReport(browser, report('comparison'));
  data = readReport(report('comparison'));
});
after(() => browser.close());

test('the times are those of two runs on their own', () => {
  const { comparison, runs } = data.report;
  const alone = [timeOf('butterfly', []),
    timeOf('butterfly', ['--machine', 'programs/machines/bench_mill.toml'])];
  assert.deepEqual(comparison.time_s, runs.map(({ time_s }) => time_s));
  alone.forEach((time, k) => assert.ok(Math.abs(time - comparison.time_s[k]) < 1e-6,
    `${comparison.time_s[k]} s instead of ${time} s`));
  assert.notEqual(...comparison.time_s);
});

test('times by limit and by line add up to the times of the runs', () => {
  const { comparison } = data.report;
  for (const [k, key] of [[0, 'a_s'], [1, 'b_s']]) {
    const sum = comparison.by_limit.reduce((total, row) => total + row[key], 0);
    assert.ok(Math.abs(sum - comparison.time_s[k]) < 0.01, `${sum} s by limit`);
    assert.ok(comparison.by_line.every((row) => row[key] <= comparison.time_s[k] + 0.01));
  }
});

test('the panel shows both times, and a click on a line chooses it', async () => {
  const { comparison } = data.report;
  await page.getByRole('tab', { name: 'Compare' }).click();
  await drawn(page);
  const panel = page.getByRole('tabpanel').filter({ visible: true });
  const text = await panel.innerText();
  for (const time of comparison.time_s) {
    assert.ok(text.replace(/\s/g, '').includes(time.toPrecision(3)), `${time} s in:\n${text}`);
  }
  const { line } = comparison.by_line[0];
  await panel.getByRole('button', { name: new RegExp(`\\b${line}\\b`) }).first().click();
  await drawn(page);
  assert.equal((await ask(page, 'selected'))?.line, line);
});

test('the legend states one scale for both runs, whichever of them is shown', async () => {
  const ends = [];
  await ask(page, 'colourBy', 'speed');
  for (const name of ['A', 'B', 'A + B']) {
    await page.getByRole('group', { name: 'Runs that are shown' })
      .getByRole('button', { name, exact: true }).click();
    await drawn(page);
    const legend = page.locator('.path .legend').first();
    assert.match(await legend.innerText(), /same scale for A and B/);
    ends.push(await legend.locator('.scale').innerText());
  }
  assert.deepEqual(ends, Array(3).fill(ends[0]));
  await ask(page, 'colourBy', 'ratio');
});

test('the panel shows how the machines differ, and the contour error of each run', async () => {
  const machine = [
    { key: 'axes.x.acceleration_mm_s2', a: '1000', b: '500' },
    { key: 'control.interpolation', a: 'taylor2 <with> corners rounded by the control', b: '' },
  ];
  const file = edited('comparison', 'machines', ({ comparison }) =>
    Object.assign(comparison, { machine, contour_um: [12.345, null] }));
  for (const size of [{}, { width: 390, height: 844 }]) {
    const other = await openReport(browser, file, size);
    const rows = await other.getByRole('region', { name: 'Machine' }).locator('tbody tr').all();
    const cells = await Promise.all(rows.map((row) => row.locator('td').allInnerTexts()));
    assert.deepEqual(cells, machine.map(({ key, a, b }) => [key, a, b || '–']));
    const paths = await other.getByRole('region', { name: 'Paths' }).innerText();
    assert.match(paths.replace(/\s+/g, ' '), /Largest contour error A 12.3 µm B –/);
    assert.ok(await other.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    assert.deepEqual(other.trouble, []);
    await other.context().close();
  }
  assert.equal(await page.getByRole('region', { name: 'Machine' }).count(),
    data.report.comparison.machine?.length ? 1 : 0);
});

test('each run is shown on its own', async () => {
  const vertices = async () => (await ask(page, 'frames')).vertices;
  await page.keyboard.press('Escape');
  await drawn(page);
  const both = await vertices();
  const found = [];
  for (const name of ['A', 'B']) {
    await page.getByRole('group', { name: 'Runs that are shown' })
      .getByRole('button', { name, exact: true }).click();
    await drawn(page);
    found.push(await vertices());
  }
  assert.ok(found.every((count) => count > 100 && count < both), `${found} of ${both}`);
  assert.deepEqual(page.trouble, []);
});
