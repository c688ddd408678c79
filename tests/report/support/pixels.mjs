// SPDX-License-Identifier: MIT
// Reads the colours of a screenshot: PNG of eight bits per channel, as Chromium writes it.
import { inflateSync } from 'node:zlib';

/** Returns the width, the height and a function (x, y) to [red, green, blue] of a PNG. */
export function readPng(png) {
  const width = png.readUInt32BE(16), height = png.readUInt32BE(20);
  const channels = { 2: 3, 6: 4 }[png[25]];
  if (png[24] !== 8 || channels === undefined) throw new Error('not a PNG of 8-bit RGB');
  const parts = [];
  for (let at = 8; at < png.length;) {
    const size = png.readUInt32BE(at);
    if (png.toString('latin1', at + 4, at + 8) === 'IDAT') {
      parts.push(png.subarray(at + 8, at + 8 + size));
    }
    at += size + 12;
  }
  const rows = unfilter(inflateSync(Buffer.concat(parts)), width * channels, height, channels);
  const colour = (x, y) => {
    const at = (Math.round(y) * width + Math.round(x)) * channels;
    return [rows[at], rows[at + 1], rows[at + 2]];
  };
  return { width, height, colour };
}

/** Undoes the filters of PNG (RFC 2083, section 6). */
function unfilter(data, stride, height, step) {
  const rows = new Uint8Array(stride * height);
  for (let y = 0; y < height; y++) {
    const kind = data[y * (stride + 1)];
    for (let x = 0; x < stride; x++) {
      const at = y * stride + x;
      const left = x >= step ? rows[at - step] : 0;
      const up = y > 0 ? rows[at - stride] : 0;
      const corner = x >= step && y > 0 ? rows[at - stride - step] : 0;
      const guess = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][kind];
      rows[at] = data[y * (stride + 1) + 1 + x] + guess;
    }
  }
  return rows;
}

function paeth(left, up, corner) {
  const guess = left + up - corner;
  const a = Math.abs(guess - left), b = Math.abs(guess - up), c = Math.abs(guess - corner);
  return a <= b && a <= c ? left : b <= c ? up : corner;
}

/** Returns the largest difference of two colours in one channel, 0 to 255. */
export function difference(a, b) {
  return Math.max(...a.map((value, k) => Math.abs(value - b[k])));
}

/** Returns the least difference of `wanted` from the pixels within `reach` of a place. */
export function nearestDifference(image, x, y, wanted, reach = 2) {
  let least = Infinity;
  for (let dy = -reach; dy <= reach; dy++) {
    for (let dx = -reach; dx <= reach; dx++) {
      const px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px > image.width - 1 || py > image.height - 1) continue;
      least = Math.min(least, difference(image.colour(px, py), wanted));
    }
  }
  return least;
}
