// SPDX-License-Identifier: MIT
// Writes the pictures of reports for the documentation into the folder that is named.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { ask, drawn, openReport, placeOfRow, startBrowser } from './support/browser.mjs';
import { report } from './support/reports.mjs';

const kDesktop = { width: 1280, height: 800 };
const kPhone = { width: 390, height: 844, touch: true };
const kLarge = 150e3; // Bytes: larger pictures are reduced to 256 colours, where pngquant is there.

/** Name of the picture, report, options of the page, and what is done before. */
const kPictures = [
  ['report_butterfly', 'butterfly', kDesktop, async () => {}],
  ['report_dark', 'butterfly', { ...kDesktop, dark: true }, async (page) => {
    await ask(page, 'pick', 7);
    await ask(page, 'colourBy', 'limit');
    await ask(page, 'show', 'program');
  }],
  ['report_what_if', 'butterfly', kDesktop, (page) => ask(page, 'show', 'whatif')],
  ['report_comparison', 'comparison', kDesktop, (page) => ask(page, 'show', 'compare')],
  ['report_errors', 'errors', kDesktop, async () => {}],
  ['report_loops', 'loops', kDesktop, async (page) => {
    await ask(page, 'pick', 15);
    await ask(page, 'show', 'program');
  }],
  ['report_passes', 'passes', kDesktop, async () => {}],
  ['report_chords', 'chords', kDesktop, async (page) => {
    await page.waitForTimeout(1500);
    const { x, y } = await placeOfRow(page, 500);
    await page.mouse.move(x, y);
    for (let k = 0; k < 3; k++) await page.mouse.wheel(0, -400);
  }],
  ['report_surface', 'surface', kDesktop, (page) => ask(page, 'show', 'surface')],
  ['report_rmax', 'surface', kDesktop, async (page) => {
    await ask(page, 'show', 'surface');
    await page.getByRole('button', { name: 'Target met', exact: true }).click();
  }],
  ['report_phone', 'butterfly', kPhone, async () => {}],
  ['report_phone_dark', 'comparison', { ...kPhone, dark: true }, (page) => ask(page, 'show', 'compare')],
];

/** Reduces the colours of a large picture; without pngquant it stays as it is. */
function reduce(file, size) {
  if (size < kLarge) return;
  try {
    execFileSync('pngquant', ['--force', '--skip-if-larger', '--output', file, '256', file]);
  } catch (error) {
    console.error(`${file} is not reduced: ${error.code ?? error.status}`);
  }
}

const folder = resolve(process.argv[2]);
mkdirSync(folder, { recursive: true });
const browser = await startBrowser();
try {
  for (const [name, of, options, prepare] of kPictures) {
    const page = await openReport(browser, report(of), options);
    await page.waitForTimeout(500);
    await prepare(page);
    await drawn(page);
    await page.waitForTimeout(500);
    const picture = await page.screenshot();
    const file = join(folder, `${name}.png`);
    writeFileSync(file, picture);
    reduce(file, picture.length);
    for (const entry of page.trouble) {
      console.error(`${name}: ${entry}`);
      process.exitCode = 1;
    }
    await page.context().close();
    console.log(file);
  }
} finally {
  await browser.close();
}
