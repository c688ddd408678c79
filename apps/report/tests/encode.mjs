// SPDX-License-Identifier: MIT
// Writes columns as the format states it, with BigInt: independent of what decodes them.

/** Appends columns and texts to a blob. */
export class BlobWriter {
  bytes = [];

  slice(bytes) {
    const offset = this.bytes.length;
    for (const byte of bytes) this.bytes.push(byte);
    return {offset, bytes: this.bytes.length - offset};
  }

  column(integers, order = 0, scale = 1) {
    let values = integers.map(BigInt);
    for (let pass = 0; pass < order; ++pass)
      values = values.map((value, i) => value - (i ? values[i - 1] : 0n));
    const bytes = values.flatMap((value) => varint(value >= 0n ? 2n * value : -2n * value - 1n));
    return {...this.slice(bytes), count: integers.length, scale, order};
  }

  get blob() {
    return Uint8Array.from(this.bytes);
  }
}

function varint(value) {
  const bytes = [];
  for (; value >= 128n; value >>= 7n) bytes.push(Number((value & 127n) | 128n));
  return [...bytes, Number(value)];
}

/** Returns numbers from 0 to 1 that look random and are the same every time (Park and Miller). */
export function randoms(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}
