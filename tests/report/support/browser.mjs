// SPDX-License-Identifier: MIT
// Opens reports in Debian's Chromium, and collects what a report must not do.
import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { pathToFileURL } from 'node:url';

// The package is installed beside the sources of the page, not beside the tests.
const require = createRequire(new URL('../../../apps/report/package.json', import.meta.url));
const { chromium } = require('playwright-core');

const kArguments = [
  '--headless', '--no-sandbox', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];
const kSoftwareWebGl = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const kNoWebGl = ['--disable-gpu', '--disable-3d-apis'];

function executable() {
  const named = process.env.CHROMIUM;
  if (named) return named;
  const found = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome']
    .find((path) => existsSync(path));
  if (!found) throw new Error('no Chromium: install the package chromium, or set CHROMIUM');
  return found;
}

/** Starts a browser; WebGL is done in software, or is missing. */
export function startBrowser({ webGl = true } = {}) {
  return chromium.launch({
    executablePath: executable(),
    args: [...kArguments, ...(webGl ? kSoftwareWebGl : kNoWebGl)],
  });
}

/**
 * Opens a file. `trouble` of the page lists errors of scripts, messages of the console that are
 * errors or warnings, and every request that is not the file itself.
 */
export async function openPage(browser, file, { width = 1280, height = 800, dark = false,
  scale = 1, touch = false } = {}) {
  const context = await browser.newContext({
    viewport: { width, height }, colorScheme: dark ? 'dark' : 'light', deviceScaleFactor: scale,
    hasTouch: touch, reducedMotion: 'reduce',
  });
  const page = await context.newPage();
  const url = pathToFileURL(file).href;
  page.trouble = [];
  page.on('pageerror', (error) => page.trouble.push(`error: ${error.stack ?? error}`));
  page.on('console', (message) => {
    if (isTrouble(message)) page.trouble.push(`${message.type()}: ${message.text()}`);
  });
  page.on('request', (request) => {
    const asked = request.url();
    if (asked !== url && !/^(data|blob):/.test(asked)) page.trouble.push(`request of ${asked}`);
  });
  await page.goto(url);
  return page;
}

/** The browser's own remarks on how fast its software WebGL reads are no trouble of the page. */
function isTrouble(message) {
  return ['error', 'warning'].includes(message.type()) &&
    !/GPU stall due to ReadPixels|Automatic fallback to software WebGL/.test(message.text());
}

/** Opens a report and waits for its first picture. */
export async function openReport(browser, file, options) {
  const page = await openPage(browser, file, options);
  await page.waitForFunction(() => window.softcncReport?.readyMs > 0, undefined,
    { timeout: 60000 });
  return page;
}

/** Calls a function of `window.softcncReport`. */
export function ask(page, name, ...values) {
  return page.evaluate(([key, list]) => window.softcncReport[key](...list), [name, values]);
}

/** Waits until the page has drawn what was asked for before. */
export function drawn(page) {
  return page.evaluate(() => new Promise((done) => {
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 20)));
  }));
}

/** The element of the picture of the path. */
export const kPath = '[role=application][aria-label^="Path of the tool"]';

/** Returns where a row of a run is drawn, in CSS pixels of the page. */
export async function placeOfRow(page, row, run = 0) {
  return page.evaluate(([selector, layer, at]) => {
    const element = document.querySelector(selector);
    const box = element.getBoundingClientRect();
    const [x, y] = element.placeOf(layer, at);
    return { x: box.left + x, y: box.top + y };
  }, [kPath, run, row]);
}
