// SPDX-License-Identifier: MIT
// Decodes the data of a report from its file, with none of the page's code.
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';

/** Returns the JSON of a report and its bytes. */
export function readReport(file) {
  const html = readFileSync(file, 'utf8');
  const part = (id) => {
    const found = new RegExp(`<script type="[^"]*" id="${id}">([^<]*)</script>`).exec(html);
    if (!found) throw new Error(`${file} has no element ${id}`);
    return found[1];
  };
  return {
    report: JSON.parse(part('softcnc-report')),
    blob: gunzipSync(Buffer.from(part('softcnc-data'), 'base64')),
  };
}

/** Returns the values of a column: zigzag varints, differenced `order` times. */
export function decode(blob, { offset, bytes, count, scale, order }) {
  const values = [];
  let at = offset;
  while (values.length < count) {
    let zigzag = 0n, shift = 0n, byte;
    do {
      byte = blob[at++];
      zigzag |= BigInt(byte & 127) << shift;
      shift += 7n;
    } while (byte > 127);
    values.push(Number(zigzag & 1n ? -((zigzag + 1n) >> 1n) : zigzag >> 1n));
  }
  if (at !== offset + bytes) throw new Error('a column has bytes left');
  for (let pass = 0; pass < order; pass++) {
    for (let i = 1; i < count; i++) values[i] += values[i - 1];
  }
  return values.map((value) => value * scale);
}

/** Returns the stretches of a line in rows; stretches that touch are one. */
export function stretchesOf({ report, blob }, line, { run = 0, file = 0 } = {}) {
  const data = report.runs[run];
  const rows = decode(blob, data.nodes.row);
  const [starts, lines, files] =
    ['row', 'line', 'file'].map((name) => decode(blob, data.spans[name]));
  const found = [];
  lines.forEach((of, i) => {
    if (of !== line || files[i] !== file) return;
    const from = starts[i], to = starts[i + 1] ?? rows.at(-1);
    if (found.length > 0 && found.at(-1).to >= from) found.at(-1).to = to;
    else if (to > from) found.push({ from, to });
  });
  return found;
}

/** Returns the rows of a CSV trace as objects of numbers; `limit` stays text. */
export function readTrace(file) {
  const lines = readFileSync(file, 'utf8').trim().split('\n').filter((line) => line[0] !== '#');
  const names = lines[0].split(',');
  return lines.slice(1).map((line) => {
    const row = {};
    line.split(',').forEach((text, k) => {
      row[names[k]] = names[k] === 'limit' ? text : Number(text);
    });
    return row;
  });
}
