// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';

import {randoms} from './encode.mjs';
import {load} from './load.mjs';

const {decimate, gridPlaces} = await load('data/decimation.ts');

/** Rows and values of a random column; `dense` samples of it, by the meaning of `between`. */
function sampled(between, count = 3000) {
  const random = randoms(5);
  const xs = [0];
  while (xs.length < count) xs.push(xs[xs.length - 1] + 1 + Math.floor(random() * 5));
  const ys = xs.map(() => random());
  const at = (x) => {
    const next = xs.findIndex((of) => of >= x);
    if (next <= 0 || between === 'interval') return ys[next];
    return ys[next - 1] +
        ((x - xs[next - 1]) / (xs[next] - xs[next - 1])) * (ys[next] - ys[next - 1]);
  };
  return {xs, ys, at};
}

for (const between of ['linear', 'interval'])
  test(`each bucket has the least and the largest of its ${between} values`, () => {
    const {xs, ys, at} = sampled(between);
    const grid = {from: 100.25, to: 700.75, buckets: 40};
    const out = decimate(xs, ys, grid, between, 2);
    const width = (grid.to - grid.from) / grid.buckets;
    for (let bucket = 0; bucket < grid.buckets; ++bucket) {
      const low = grid.from + bucket * width;
      const inside =
          xs.map((x, i) => (x >= low && x <= low + width ? ys[i] : NaN)).filter((y) => y === y);
      const values = [at(low), ...inside, at(low + width)];
      const found = [out[2 * bucket], out[2 * bucket + 1]].sort((a, b) => a - b);
      assert.ok(Math.abs(found[0] - 2 * Math.min(...values)) < 1e-12, `bucket ${bucket}`);
      assert.ok(Math.abs(found[1] - 2 * Math.max(...values)) < 1e-12, `bucket ${bucket}`);
    }
  });

test('one deep zoom between two nodes shows the line between them', () => {
  const grid = {from: 2, to: 3, buckets: 10};
  const out = decimate([0, 10], [0, 100], grid, 'linear');
  gridPlaces(grid).forEach((place, i) => assert.ok(Math.abs(out[i] - 10 * place) <= 0.5 + 1e-9));
});

test('a single high value is never lost', () => {
  const ys = new Float64Array(250000);
  ys[123456] = 9;
  const out = decimate(ys.map((_, i) => i), ys, {from: 0, to: 249999, buckets: 700}, 'linear');
  assert.equal(Math.max(...out), 9);
});

test('places outside the run, and values that there are not, are empty', () => {
  const grid = {from: 0, to: 40, buckets: 4};
  assert.deepEqual(
      decimate([0, 10, 20], [1, 1, 1], {...grid, from: 25, to: 65}, 'linear'), Array(8).fill(null));
  const out = decimate([0, 10, 20, 30, 40], [-1, -1, -1, 5, 5], grid, 'interval', 1, 0);
  assert.deepEqual(out.slice(0, 2), [null, null]);
  assert.deepEqual(out.slice(6), [5, 5]);
  assert.deepEqual(decimate([], [], grid, 'linear'), Array(8).fill(null));
});
