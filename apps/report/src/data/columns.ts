// SPDX-License-Identifier: MIT
// Decodes columns: integers as zigzag LEB128, as such or as their first or second differences.
import type { Column } from './format.ts';

/**
 * Returns the `count` values of a column, each an integer times `scale`. Throws a RangeError where
 * the column does not lie within `blob` or its bytes end within a number. Integers may have up to
 * 53 bits.
 */
export function decodeColumn(blob: Uint8Array, column: Column): Float64Array {
  const values = integers(blob, column);
  for (let pass = 0; pass < column.order; ++pass) accumulate(values);
  if (column.scale !== 1) for (let i = 0; i < values.length; ++i) values[i]! *= column.scale;
  return values;
}

/** Sums up differences in place. */
function accumulate(values: Float64Array): void {
  let sum = 0;
  for (let i = 0; i < values.length; ++i) values[i] = sum += values[i]!;
}

function integers(blob: Uint8Array, { offset, bytes, count }: Column): Float64Array {
  const end = offset + bytes;
  if (offset < 0 || bytes < count || end > blob.length)
    throw new RangeError('a column of the report is cut off');
  const values = new Float64Array(count);
  let at = offset;
  for (let i = 0; i < count; ++i) {
    let byte = blob[at++]!;
    let zigzag = byte & 0x7f;
    // Multiplication, since bit operations have 32 bits only.
    for (let factor = 128; byte >= 0x80; factor *= 128) {
      if (at >= end) throw new RangeError('a column of the report is cut off');
      byte = blob[at++]!;
      zigzag += (byte & 0x7f) * factor;
    }
    values[i] = zigzag % 2 === 0 ? zigzag / 2 : -(zigzag + 1) / 2;
  }
  return values;
}
