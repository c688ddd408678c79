// SPDX-License-Identifier: MIT
// Compiles a source of the page, with all that it imports, and loads it into Node.
import {fileURLToPath} from 'node:url';
import {build} from 'vite';

/** Returns the exports of a file of `src`. */
export async function load(file) {
  const entry = fileURLToPath(new URL(`../src/${file}`, import.meta.url));
  const made = await build({
    configFile: false,
    logLevel: 'error',
    build: {write: false, minify: false, target: 'es2022', lib: {entry, formats: ['es']}},
  });
  const {code} = made[0].output[0];
  return import(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
}
