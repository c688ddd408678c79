// SPDX-License-Identifier: MIT
// Measures the report of the large program, for `measure`, which says how it is called.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { availableParallelism, loadavg, tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';
import { ask, kPath, openReport, startBrowser } from './support/browser.mjs';
import { readReport } from './support/decode.mjs';
import { raster } from './support/programs.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    program: { type: 'string' }, set: { type: 'string', multiple: true },
    seconds: { type: 'string', default: '5' },
  },
});
const kMega = 1e6;
const rows = [];

/** Notes a figure; `most` or `least` is its limit. */
function note(what, value, unit, { most, least } = {}) {
  const isMet = (most === undefined || value <= most) && (least === undefined || value >= least);
  const limit = most !== undefined ? `≤ ${most}` : least !== undefined ? `≥ ${least}` : '';
  rows.push({ what, value: value.toFixed(value >= 100 ? 0 : 2), unit, limit, isMet });
}

function timed(command, parameters) {
  const start = performance.now();
  execFileSync(command, parameters, { stdio: ['ignore', 'ignore', 'inherit'] });
  return (performance.now() - start) / 1e3;
}

/** Makes the report of the large program; returns its file. */
function make(folder) {
  if (!process.env.SOFTCNC) throw new Error('set SOFTCNC to the program softcnc');
  const softcnc = resolve(process.env.SOFTCNC);
  const part = values.program ?? join(folder, 'raster.nc');
  if (!values.program) writeFileSync(part, raster());
  const settings = (values.set ?? ['control.period_ms=2.4']).flatMap((entry) => ['--set', entry]);
  const report = join(folder, 'raster.html');
  const traced = timed(softcnc,
    ['run', '--dry-run', part, ...settings, '--trace', join(folder, 'raster.npz')]);
  const made = timed(softcnc, ['report', part, ...settings, '-o', report]);
  note('run with a trace', traced, 's');
  note('report', made, 's', { most: Number((1.5 * traced).toFixed(1)) });
  return report;
}

/** Notes the sizes of the file and of what it holds. */
function weigh(file) {
  const { report, blob } = readReport(file);
  const size = statSync(file).size;
  const texts = report.runs.flatMap(({ files }) => files).map(({ text }) => text).filter(Boolean);
  const withoutText = Buffer.concat(texts
    .sort((a, b) => a.offset - b.offset)
    .reduce((parts, { offset, bytes }) => {
      const last = parts.pop();
      const at = blob.length - last.length;
      return [...parts, last.subarray(0, offset - at), last.subarray(offset + bytes - at)];
    }, [blob]));
  const base64 = (bytes) => 4 * Math.ceil(gzipSync(bytes, { level: 9 }).length / 3);
  note('setpoints', report.runs[0].setpoints, '');
  note('nodes', report.runs[0].nodes.row.count, '');
  note('file', size / kMega, 'MB', { most: 10 });
  note('without the program', (size - base64(blob) + base64(withoutText)) / kMega, 'MB', { most: 4 });
}

/** Drags the path around for some seconds; returns frames per second. */
async function turn(page, seconds) {
  await page.keyboard.press('3');
  return page.evaluate(async ([selector, duration]) => {
    const element = document.querySelector(selector);
    element.setPointerCapture = () => {};
    const box = element.getBoundingClientRect();
    let x = box.left + box.width / 2, frames = 0;
    const y = box.top + box.height / 2;
    const send = (type) => element.dispatchEvent(new PointerEvent(type,
      { clientX: x, clientY: y + 20 * Math.sin(x / 40), pointerId: 1, buttons: 1, bubbles: true }));
    const frame = () => new Promise((done) => { requestAnimationFrame(done); });
    send('pointerdown');
    const start = performance.now();
    let now = start, slowest = 0, vertices = 0;
    while (now - start < 1e3 * duration) {
      x += 5;
      send('pointermove');
      await frame();
      const next = performance.now();
      slowest = Math.max(slowest, next - now);
      now = next;
      frames++;
      vertices = Math.max(vertices, window.softcncReport.frames().vertices);
    }
    send('pointerup');
    return { rate: 1e3 * frames / (now - start), slowest, vertices };
  }, [kPath, seconds]);
}

const folder = mkdtempSync(join(tmpdir(), 'softcnc-measure-'));
try {
  const file = positionals[0] ? resolve(positionals[0]) : make(folder);
  weigh(file);
  const browser = await startBrowser();
  try {
    const page = await openReport(browser, file);
    note('first view', await page.evaluate('softcncReport.readyMs') / 1e3,
      's', { most: 3 });
    await page.waitForTimeout(1500); // the charts are made
    const full = (await ask(page, 'frames')).vertices;
    const turned = await turn(page, Number(values.seconds));
    note('frames per second while turning', turned.rate, '1/s', { least: 15 });
    note('slowest frame', turned.slowest, 'ms');
    note('vertices of a frame', Math.max(full, turned.vertices), '', { most: 40000 });
    for (const entry of page.trouble) console.error(entry);
    if (page.trouble.length > 0) process.exitCode = 1;
  } finally {
    await browser.close();
  }
} finally {
  rmSync(folder, { recursive: true, force: true });
}
console.log(`${availableParallelism()} cores, load ${loadavg()[0].toFixed(1)}; drawn in software`);
for (const { what, value, unit, limit, isMet } of rows) {
  console.log(`${what.padEnd(34)}${value.padStart(10)} ${unit.padEnd(4)} ${limit.padEnd(10)}` +
    (limit ? isMet ? 'met' : 'MISSED' : ''));
}
if (rows.some(({ isMet }) => !isMet)) process.exitCode = 1;
