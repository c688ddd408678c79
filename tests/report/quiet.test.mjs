// SPDX-License-Identifier: MIT
// Every report is shown without an error, and asks for nothing beyond its file.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ask, drawn, openPage, openReport, startBrowser } from './support/browser.mjs';
import { readReport } from './support/decode.mjs';
import { report } from './support/reports.mjs';
import { kPrograms } from './support/programs.mjs';
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { kFolder } from './support/reports.mjs';

let browser;
before(async () => { browser = await startBrowser(); });
after(() => browser.close());

for (const name of Object.keys(kPrograms)) {
  test(`${name}: no error, no request, and the numbers of the run`, async () => {
    const file = report(name);
    const page = await openReport(browser, file);
    const { report: { runs } } = readReport(file);
    const shown = await ask(page, 'runs');
    assert.deepEqual(shown.map(({ time_s, status }) => [time_s, status]),
      runs.map(({ time_s, status }) => [time_s, status]));
    assert.deepEqual(shown.map(({ nodes }) => nodes), runs.map(({ nodes }) => nodes.row.count));
    for (const tab of await page.getByRole('tab').all()) {
      await tab.click();
      await drawn(page);
      const panel = page.getByRole('tabpanel').filter({ visible: true });
      assert.ok((await panel.innerText()).trim().length > 10, `${await tab.innerText()} is empty`);
    }
    assert.deepEqual(page.trouble, []);
    await page.context().close();
  });
}

test('without WebGL the path is drawn on a canvas', async () => {
  const plain = await startBrowser({ webGl: false });
  try {
    const page = await openReport(plain, report('butterfly'));
    await drawn(page);
    const frames = await ask(page, 'frames');
    assert.ok(frames.vertices > 100, JSON.stringify(frames));
    assert.deepEqual(page.trouble, []);
  } finally {
    await plain.close();
  }
});

test('an error of a script and a request are noticed', async () => {
  const file = join(kFolder, 'loud.html');
  writeFileSync(file, '<!doctype html><img src="https://example.invalid/a.png">' +
    '<script>setTimeout(() => { throw new Error("loud"); })</script>');
  const page = await openPage(browser, file);
  await page.waitForTimeout(300);
  assert.ok(page.trouble.some((entry) => entry.includes('loud')), page.trouble.join('\n'));
  assert.ok(page.trouble.some((entry) => entry.startsWith('request of https://example.invalid')));
  await page.context().close();
});
