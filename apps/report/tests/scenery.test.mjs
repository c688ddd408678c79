// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';

import {load} from './load.mjs';

const {namedOutlines, originsOf, workpiecesOf} = await load('ui/pictures/scenery.ts');
const {boxOfOutlines} = await load('view/path/outlines.ts');

const at = (name, x, y = 0, z = 0) => ({name, at_mm: [x, y, z]});
const run = (data) => ({data});
const names = (list) => list.map(({name}) => name);

test('systems at one place have one cross with all their names', () => {
  const found = originsOf([run({origins: [at('G54', 1), at('G55', 2), at('G56', 1)]})], [true]);
  assert.deepEqual(found, [{at: [1, 0, 0], name: 'G54, G56'}, {at: [2, 0, 0], name: 'G55'}]);
  const many = originsOf([run({origins: [4, 5, 6, 7, 8].map((k) => at(`G5${k}`, 0))})], [true]);
  assert.deepEqual(names(many), ['G54, G55, G56 +2']);
  assert.deepEqual(originsOf([run({})], [true]), []);
});

test('a system of two runs has a letter only where their places differ', () => {
  const runs = [run({origins: [at('G54', 1), at('G55', 5)]}), run({origins: [at('G54', 2), at('G55', 5)]})];
  assert.deepEqual(names(originsOf(runs, [true, true])), ['G54 A', 'G55', 'G54 B']);
  assert.deepEqual(names(originsOf(runs, [false, true])), ['G54', 'G55']);
  assert.deepEqual(names(originsOf([runs[0], run({})], [true, true])), ['G54', 'G55']);
});

test('a workpiece of both runs is drawn once', () => {
  const piece = (name, ...edges_mm) => run({workpieces: [{name, line: 3, edges_mm}]});
  const drawn = (...runs) => names(namedOutlines(workpiecesOf(runs), runs.map(() => true)));
  const edge = [0, 0, 0, 1, 0, 0];
  assert.deepEqual(drawn(piece('a', ...edge), piece('a', ...edge)), ['a']);
  assert.deepEqual(drawn(piece('a', ...edge), piece('a', 9, ...edge.slice(1))), ['a A', 'a B']);
  assert.deepEqual(drawn(piece('', ...edge)), ['workpiece']);
  assert.deepEqual(namedOutlines(workpiecesOf([piece('a', ...edge)]), [false]), []);
});

test('the box of outlines is from the centre of the picture', () => {
  const edges = [0, 1, 2, 10, 1, -2, 3, 8, 0, 3, 8, 0];
  assert.deepEqual(
      boxOfOutlines([{edges}], [1, 1, 1]), {low: [-1, 0, -3], high: [9, 7, 1]});
  assert.equal(boxOfOutlines([], [0, 0, 0]), null);
});
