// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';
import {gzipSync} from 'node:zlib';

import {BlobWriter, randoms} from './encode.mjs';
import {load} from './load.mjs';

const {decodeColumn} = await load('data/columns.ts');
const {bytesOfBase64, gunzip} = await load('data/blob.ts');

test('columns of every order are read as they were written', () => {
  const random = randoms(1);
  const integers =
      Array.from({length: 1000}, () => Math.round((random() - 0.5) * 10 ** (15 * random())) + 0);
  const writer = new BlobWriter();
  writer.slice([255, 255]);  // columns need not begin with the blob
  for (const order of [0, 1, 2]) {
    const column = writer.column(integers, order);
    assert.deepEqual([...decodeColumn(writer.blob, column)], integers, `order ${order}`);
  }
});

test('the largest integers of doubles survive', () => {
  const writer = new BlobWriter();
  const ends = [0, -1, 1, 2 ** 31, -(2 ** 32), 2 ** 52 - 1, -(2 ** 52)];
  assert.deepEqual([...decodeColumn(writer.blob, writer.column([]))], []);
  const column = writer.column(ends);
  assert.deepEqual([...decodeColumn(writer.blob, column)], ends);
});

test('values are integers times the scale', () => {
  const writer = new BlobWriter();
  const column = writer.column([5, -7], 1, 0.25);
  assert.deepEqual([...decodeColumn(writer.blob, column)], [1.25, -1.75]);
});

test('a column that is cut off is refused', () => {
  const writer = new BlobWriter();
  const column = writer.column([1, 300, 5]);
  assert.throws(() => decodeColumn(writer.blob.slice(0, 3), column), RangeError);
  assert.throws(() => decodeColumn(writer.blob, {...column, bytes: 2}), RangeError);
  assert.throws(() => decodeColumn(writer.blob, {...column, count: 4}), RangeError);
});

test('the blob is unpacked from base64 of gzip', async () => {
  const bytes = Uint8Array.from({length: 70000}, (_, i) => (i * i) % 251);
  const text = gzipSync(bytes).toString('base64');
  assert.deepEqual(await gunzip(bytesOfBase64(text)), bytes);
  await assert.rejects(gunzip(bytesOfBase64(text).slice(0, 100)));
});
