// SPDX-License-Identifier: MIT
// A page whose data are damaged says so in words.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openPage, startBrowser } from './support/browser.mjs';
import { kFolder, report } from './support/reports.mjs';

let browser;
before(async () => { browser = await startBrowser(); });
after(() => browser.close());

/** Opens the butterfly's report after a change of its text; returns what the page says. */
async function shownAfter(name, change) {
  const html = readFileSync(report('butterfly'), 'utf8');
  const changed = change(html);
  assert.notEqual(changed, html);
  const file = join(kFolder, `${name}.html`);
  writeFileSync(file, changed);
  const page = await openPage(browser, file);
  const alert = page.getByRole('alert').or(page.locator('.empty')).filter({ visible: true }).first();
  await alert.waitFor({ timeout: 10000 });
  const text = await alert.innerText();
  await page.context().close();
  return text;
}

const kCases = {
  'bytes that are not base64': (html) => html.replace(/(id="softcnc-data">.{40})../, '$1%%'),
  'bytes that are cut off': (html) =>
    html.replace(/(id="softcnc-data">[^<]{1000})[^<]*/, '$1'),
  'bytes that are changed': (html) =>
    html.replace(/(id="softcnc-data">[^<]{800})[^<]{40}/, (_, head) => head + 'A'.repeat(40)),
  'JSON that is cut off': (html) => html.replace(/(id="softcnc-report">.{300})[^<]*/, '$1'),
  'another schema': (html) => html.replace('"schema":1', '"schema":99'),
};

for (const [name, change] of Object.entries(kCases)) {
  test(`${name}: the page says that it cannot be read`, async () => {
    const text = await shownAfter(`damaged ${name}`, change);
    assert.match(text, /cannot be read/);
    assert.ok(text.length > 40, text);
  });
}

test('a page without data says where they come from', async () => {
  const text = await shownAfter('empty', (html) =>
    html.replace(/<script type="application\/json" id="softcnc-report">[^<]*<\/script>/, ''));
  assert.match(text, /softcnc report/);
});
