// SPDX-License-Identifier: MIT
// Makes the reports that the tests look at, each once, by the softcnc that SOFTCNC names.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { kPrograms } from './programs.mjs';

const kRoot = fileURLToPath(new URL('../../../', import.meta.url));

/** The folder of the reports: REPORTS, where `run` has made one for all test files. */
export const kFolder = process.env.REPORTS ?? mkdtempSync(join(tmpdir(), 'softcnc-report-'));
mkdirSync(kFolder, { recursive: true });

function softcnc() {
  if (!process.env.SOFTCNC) throw new Error('set SOFTCNC to the program softcnc');
  return resolve(process.env.SOFTCNC);
}

/**
 * Runs softcnc where the program's name is short; returns what it prints. A part program with errors
 * makes it fail: see `fails`.
 */
function run(name, parameters, fails) {
  const command = softcnc();
  try {
    return execFileSync(command, parameters,
      { cwd: kPrograms[name].file ? kRoot : kFolder, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
  } catch (error) {
    if (fails) return error.stdout;
    throw new Error(`softcnc ${parameters.join(' ')} has failed:\n${error.stderr ?? error}`);
  }
}

/** Returns the name of a part program; one that is written here is written first. */
function program(name) {
  const { text, file } = kPrograms[name];
  if (file) return file;
  const path = join(kFolder, `${name}.nc`);
  if (!existsSync(path)) writeFileSync(path, text());
  return `${name}.nc`;
}

/** Returns the file of a report, which is made if it does not exist. */
export function report(name) {
  const { options = [], fails = false } = kPrograms[name];
  const path = join(kFolder, `${name}.html`);
  if (existsSync(path)) return path;
  run(name, ['report', program(name), '-o', path, ...options], fails);
  if (!existsSync(path)) throw new Error(`softcnc report has written no report of ${name}`);
  return path;
}

/** Returns the file of a report whose data `change` has changed, under a name of its own. */
export function edited(name, as, change) {
  const html = readFileSync(report(name), 'utf8');
  const path = join(kFolder, `${as}.html`);
  writeFileSync(path, html.replace(/(id="softcnc-report">)([^<]*)/, (_, tag, text) => {
    const data = JSON.parse(text);
    change(data);
    return tag + JSON.stringify(data).replaceAll('<', '\\u003c');
  }));
  return path;
}

/** Returns the file of a CSV trace of the same run. */
export function trace(name) {
  const path = join(kFolder, `${name}.csv`);
  if (!existsSync(path)) run(name, ['run', '--dry-run', program(name), '--trace', path], false);
  return path;
}

/** Returns the time in s of a run of the program on its own, with these parameters. */
export function timeOf(name, parameters) {
  const path = join(kFolder, 'time.json');
  run(name, ['run', '--dry-run', program(name), '--quiet', '--report', path, ...parameters], false);
  return JSON.parse(readFileSync(path, 'utf8')).time_s;
}
