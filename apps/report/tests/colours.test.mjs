// SPDX-License-Identifier: MIT
// The same value has the same colour in both runs of a comparison.
import assert from 'node:assert/strict';
import test from 'node:test';

import {BlobWriter} from './encode.mjs';
import {load} from './load.mjs';

const {RunModel} = await load('data/run_model.ts');
const {categoriesOf, coloursOf, QUANTITIES, quantitiesOf, scaleOf} =
    await load('ui/common/quantities.ts');

const MEASURES = ['acceleration_use', 'jerk_use', 'contour_um', 'deviation_um', 'chord_error_um',
  'rmax_um'];

/** A run that cuts, whose measures are `values`, with its own numbers of limits and its tools. */
function run(values, limits, tools) {
  const writer = new BlobWriter();
  const column = (list) => writer.column(list, 0, 1);
  const count = values.length;
  const nodes = {
    row: column(values.map((_, i) => i)),
    motion: column(Array(count).fill(1)),
    feed: column(Array(count).fill(100)),
    v: column(values),
    limit: column(values.map((_, i) => i % limits.length)),
    tool: column(values.map((_, i) => tools[i % tools.length])),
  };
  for (const name of MEASURES) nodes[name] = column(values);
  return new RunModel(
      {
        nodes,
        limits,
        period_s: 0.001,
        axis_limits: [{axis: 'x', jerk_mm_s3: 1}],
        tools: tools.map((tool) => ({tool})),
        time_by_limit_s: limits.map((limit) => ({limit, seconds: 1})),
      },
      writer.blob);
}

const RUNS = [
  run([5, 5, 20, 20, 40, 40], ['feed', 'jerk'], [2]),
  run([5, 5, 40, 40, 80, 80], ['jerk', 'acceleration', 'feed'], [1, 2, 7])
];
const colours = (index, id, dark = false) => {
  const quantity = QUANTITIES.find((one) => one.id === id);
  const rgb = coloursOf(RUNS, index, quantity, scaleOf(RUNS, quantity), dark);
  return Array.from({length: rgb.length / 3}, (_, i) => [...rgb.slice(3 * i, 3 * i + 3)].join());
};
const NUMBERS = quantitiesOf(RUNS).map(({id}) => id)
                    .filter((id) => !['limit', 'tool', 'run'].includes(id));

test('every number that can be compared is tested', () => assert.equal(NUMBERS.length, 8));

for (const id of NUMBERS)
  test(`${id} has one scale in both runs`, () => {
    for (const dark of [false, true]) {
      const [a, b] = [0, 1].map((index) => colours(index, id, dark));
      assert.equal(a[1], b[1], '5 in both');
      assert.equal(a[5], b[3], '40 in both');
      assert.notEqual(a[3], b[3], '20 is not 40');
      assert.notEqual(a[5], b[5], '40 is not 80');
    }
  });

test('limits and tools have the colours of the legend in both runs, however they are counted', () => {
  const hex = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16)).join();
  const legend = (id) => categoriesOf(RUNS, id).map(({colour}) => hex(colour));
  const [t1, t2, t7] = legend('tool');
  assert.deepEqual(colours(0, 'tool'), Array(6).fill(t2));
  assert.deepEqual(colours(1, 'tool'), [t1, t2, t7, t1, t2, t7]);
  const [feed, jerk, acceleration] = legend('limit');
  assert.deepEqual(colours(0, 'limit').slice(0, 2), [feed, jerk]);
  assert.deepEqual(colours(1, 'limit').slice(0, 3), [jerk, acceleration, feed]);
});
