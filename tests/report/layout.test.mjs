// SPDX-License-Identifier: MIT
// On a desktop and on a phone, light and dark, nothing is wider than the page or above other text.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { drawn, openReport, startBrowser } from './support/browser.mjs';
import { report } from './support/reports.mjs';

const kSizes = [{ width: 1280, height: 800 }, { width: 390, height: 844 }];
let browser;
before(async () => { browser = await startBrowser(); });
after(() => browser.close());

/** Runs in the page: what is beyond its width, and texts of which one covers another. */
function findMisplaced() {
  const wide = [];
  if (document.documentElement.scrollWidth > innerWidth) {
    wide.push(`the page is ${document.documentElement.scrollWidth} px wide`);
  }
  const clips = (element) => {
    const style = getComputedStyle(element);
    return style.overflowX !== 'visible' || style.overflowY !== 'visible';
  };
  const texts = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (!node.data.trim() || parent.closest('script, style, option, .unseen')) continue;
    if (!parent.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    const range = document.createRange();
    range.selectNodeContents(node);
    for (const box of range.getClientRects()) {
      const seen = { left: box.left, top: box.top, right: box.right, bottom: box.bottom };
      for (let at = parent; at; at = at.parentElement) {
        if (at === document.documentElement || !clips(at)) continue;
        const edge = at.getBoundingClientRect();
        seen.left = Math.max(seen.left, edge.left);
        seen.right = Math.min(seen.right, edge.right);
        seen.top = Math.max(seen.top, edge.top);
        seen.bottom = Math.min(seen.bottom, edge.bottom);
      }
      if (seen.right - seen.left < 2 || seen.bottom - seen.top < 4) continue;
      if (seen.right > innerWidth + 1) wide.push(`"${node.data.trim()}" ends at ${seen.right} px`);
      texts.push({ text: node.data.trim().slice(0, 40), parent, ...seen });
    }
  }
  const covered = [];
  texts.forEach((a, i) => {
    for (const b of texts.slice(i + 1)) {
      if (a.parent === b.parent || a.parent.contains(b.parent) || b.parent.contains(a.parent)) continue;
      const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (width > 2 && height > 4) covered.push(`"${a.text}" and "${b.text}"`);
    }
  });
  return { wide, covered };
}

for (const name of ['butterfly', 'comparison', 'errors', 'surface']) {
  for (const size of kSizes) {
    for (const dark of [false, true]) {
      test(`${name} at ${size.width} x ${size.height}, ${dark ? 'dark' : 'light'}`, async () => {
        const page = await openReport(browser, report(name), { ...size, dark });
        for (const tab of await page.getByRole('tab').all()) {
          await tab.click();
          await drawn(page);
          const { wide, covered } = await page.evaluate(findMisplaced);
          const where = `panel ${await tab.innerText()}`;
          assert.deepEqual(wide, [], where);
          assert.deepEqual(covered, [], where);
        }
        assert.deepEqual(page.trouble, []);
        await page.context().close();
      });
    }
  }
}

/** Runs in the page: texts whose contrast with their background is less than WCAG 2 asks for. */
function findPale() {
  const light = (rgb) => {
    const [r, g, b] = rgb.map((c) => c / 255)
      .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const parse = (text) => {
    const found = /^rgba?\(([\d.]+), ([\d.]+), ([\d.]+)(?:, ([\d.]+))?\)$/.exec(text);
    return found && { rgb: found.slice(1, 4).map(Number), alpha: Number(found[4] ?? 1) };
  };
  const pale = [];
  for (const element of document.querySelectorAll('body *')) {
    const own = [...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
    if (!own || element.closest('.unseen, script, style, option, :disabled')) continue;
    if (!element.checkVisibility({ visibilityProperty: true, opacityProperty: true })) continue;
    const colour = parse(getComputedStyle(element).color);
    let background = null;
    for (let at = element; at && !background; at = at.parentElement) {
      const found = parse(getComputedStyle(at).backgroundColor);
      if (found && found.alpha === 1) background = found.rgb;
    }
    if (!colour || !background) continue;
    const [high, low] = [light(colour.rgb), light(background)].sort((a, b) => b - a);
    const contrast = (high + 0.05) / (low + 0.05);
    if (contrast < 4.5) pale.push(`"${element.innerText.trim().slice(0, 30)}" ${contrast.toFixed(2)}`);
  }
  return pale;
}

for (const dark of [false, true]) {
  test(`texts stand out on a ${dark ? 'dark' : 'light'} page`, async () => {
    const page = await openReport(browser, report('errors'), { dark });
    const compared = await openReport(browser, report('comparison'), { dark });
    for (const shown of [page, compared]) {
      for (const tab of await shown.getByRole('tab').all()) {
        await tab.click();
        await drawn(shown);
        assert.deepEqual(await shown.evaluate(findPale), [], `panel ${await tab.innerText()}`);
      }
      await shown.context().close();
    }
  });
}
