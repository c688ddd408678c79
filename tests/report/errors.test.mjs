// SPDX-License-Identifier: MIT
// A program with errors is shown with them at their lines.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ask, drawn, openReport, startBrowser } from './support/browser.mjs';
import { readReport } from './support/decode.mjs';
import { kErrors } from './support/programs.mjs';
import { report } from './support/reports.mjs';

let browser, page, diagnostics;
before(async () => {
  browser = await startBrowser();
  page = await openReport(browser, report('errors'));
  ({ diagnostics } = readReport(report('errors')).report.runs[0]);
  await page.evaluate(() => {
    /** Returns where a character of an element's text begins, in CSS pixels. */
    window.textBox = (element, index) => {
      const range = document.createRange();
      range.setStart(element.firstChild, index);
      range.setEnd(element.firstChild, index + 1);
      return range.getBoundingClientRect().left;
    };
  });
});
after(() => browser.close());

test('the report has the errors of the program', () => {
  const lines = diagnostics.filter(({ severity }) => severity === 'error').map(({ line }) => line);
  assert.deepEqual([...new Set(lines)].sort((a, b) => a - b), kErrors.errorLines);
});

test('each error stands below its line, at its column', async () => {
  await page.getByRole('tab', { name: 'Program' }).click();
  await drawn(page);
  const text = kErrors.text.split('\n');
  for (const { line, column, message, code, severity } of diagnostics) {
    const row = page.locator(`[data-line="${line}"]`);
    assert.equal((await row.locator('code').innerText()).trim(), text[line - 1].trim());
    const below = await row.evaluate((element) => {
      const found = [];
      for (let at = element.nextElementSibling; at && !at.dataset.line; at = at.nextElementSibling) {
        found.push(at.innerText);
      }
      return found;
    });
    const at = below.findIndex((entry) => entry.includes(code) && entry.includes(message));
    assert.ok(at > 0, `${severity} of line ${line}: ${JSON.stringify(below)}`);
    if (column > 0) {
      const code = row.locator('code');
      const mark = await page.locator(`[data-line="${line}"] ~ .remark`).first().locator('code')
        .evaluate((element) => textBox(element, element.innerText.indexOf('^')));
      const sign = await code.evaluate((element, k) => textBox(element, k), column - 1);
      assert.ok(Math.abs(mark - sign) < 1.5, `the mark of line ${line} is at ${mark}, not ${sign}`);
    }
  }
});

test('a click on the place of a message shows its line', async () => {
  await page.getByRole('tab', { name: 'Messages' }).click();
  await drawn(page);
  const [first] = diagnostics;
  const message = page.getByRole('listitem').filter({ hasText: first.message }).first();
  await message.getByRole('button', { name: `:${first.line}:` }).click();
  await drawn(page);
  assert.equal((await ask(page, 'selected'))?.line, first.line);
  assert.deepEqual(page.trouble, []);
});
