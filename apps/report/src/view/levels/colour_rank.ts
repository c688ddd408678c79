// SPDX-License-Identifier: MIT
// Codes of the errors of colour that leaving out a node causes.

import { codeOfError, kRapid, kRest } from './codes.ts';

const kColourWeight = 0.25; // Full contrast counts as an error of a quarter of its length.

/** Numbers of a block: lowest and highest red, green and blue, and its length in mm. */
export const kBlock = 7;

/** What of a path decides on its colours; each has an entry per node (`rgb` three). */
export interface Intervals {
  length: Float32Array;
  motion: Uint8Array;
  rgb: Uint8Array;
  visible: Uint8Array | null;
}

/**
 * Raises the codes of the nodes of a chunk, which begins with node `first` and has `count`
 * intervals. Halves the chunk again and again; the node in the middle of a block gets the block's
 * length times its range of colours as error. `work` has space for a block per interval.
 */
export function rankColours(path: Intervals, first: number, count: number, work: Float32Array,
  codes: Uint8Array): void {
  for (let j = 0; j < count; j++) setBlock(work, kBlock * j, path, first + j + 1);
  for (let size = 2; size < 2 * count; size *= 2) {
    for (let j = 0; j + size / 2 < count; j += size) {
      const block = kBlock * j;
      const range = joinBlocks(work, block, kBlock * (j + size / 2));
      if (range < 2) continue;
      const code = codeOfError(work[block + 6]! * (range / 255) * kColourWeight);
      const node = first + j + size / 2;
      if (code > codes[node]!) codes[node] = code;
    }
  }
}

/** Sets a block to the interval that ends in a node. */
function setBlock(work: Float32Array, at: number, path: Intervals, node: number): void {
  const motion = path.motion[node]!;
  const hidden = path.visible !== null && path.visible[node] === 0;
  const drawn = path.length[node]! > 0 && motion !== kRest;
  for (let k = 0; k < 3; k++) {
    // Hidden intervals and rapids stand for colours outside of the range that bytes have.
    const value = hidden ? 600 : motion === kRapid ? -300 : path.rgb[3 * node + k]!;
    work[at + k] = drawn ? value : Infinity;
    work[at + 3 + k] = drawn ? value : -Infinity;
  }
  work[at + 6] = drawn ? path.length[node]! : 0;
}

/** Joins block `b` to block `a`; returns the largest range of red, green or blue in both. */
function joinBlocks(work: Float32Array, a: number, b: number): number {
  let range = 0;
  for (let k = 0; k < 3; k++) {
    const low = Math.min(work[a + k]!, work[b + k]!);
    const high = Math.max(work[a + 3 + k]!, work[b + 3 + k]!);
    work[a + k] = low;
    work[a + 3 + k] = high;
    if (high - low > range) range = high - low;
  }
  work[a + 6]! += work[b + 6]!;
  return range;
}
