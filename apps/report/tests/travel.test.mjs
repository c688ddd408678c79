// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';

import {BlobWriter} from './encode.mjs';
import {load} from './load.mjs';

const {RunModel} = await load('data/run_model.ts');
const {extentOf, leavesTravel, travelEdges, travelOf} = await load('data/travel.ts');

const limit = (axis, min_mm, max_mm) => ({axis, min_mm, max_mm});
const WHOLE = [limit('x', 0, 100), limit('y', -50, 50), limit('z', -20, 0)];

/** A run from (10, 0, -5) to (60, 20, -8). */
function run(axis_limits, error_um = 0) {
  const writer = new BlobWriter();
  const nodes = {row: [0, 9], x: [10000, 60000], y: [0, 20000], z: [-5000, -8000]};
  for (const name of Object.keys(nodes))
    nodes[name] = writer.column(nodes[name], 1, name === 'row' ? 1 : 0.001);
  return new RunModel({nodes, axis_limits, error_um, period_s: 0.001}, writer.blob);
}

/** Edges as texts, in any order. */
function edgesOf(limits) {
  const edges = travelEdges(travelOf(limits), extentOf(run(limits)));
  return Array.from({length: edges.length / 6}, (_, i) => edges.slice(6 * i, 6 * i + 6));
}

test('the whole travel has the twelve edges of a box', () => {
  const edges = edgesOf(WHOLE);
  assert.equal(edges.length, 12);
  assert.equal(new Set(edges.map(String)).size, 12);
  for (const [x1, y1, z1, x2, y2, z2] of edges) {
    for (const x of [x1, x2]) assert.ok(x === 0 || x === 100);
    for (const y of [y1, y2]) assert.ok(y === -50 || y === 50);
    for (const z of [z1, z2]) assert.ok(z === -20 || z === 0);
    assert.equal(Number(x1 !== x2) + Number(y1 !== y2) + Number(z1 !== z2), 1);
  }
});

test('an axis without travel leaves a rectangle at the lowest place of the path', () => {
  const edges = edgesOf(WHOLE.slice(0, 2));
  assert.equal(edges.length, 4);
  assert.ok(edges.every((edge) => edge[2] === -8 && edge[5] === -8));
});

test('a side that is not known is open', () => {
  const edges = edgesOf([limit('x', 0, null), limit('y', -50, 50), WHOLE[2]]);
  assert.equal(edges.length, 8);
  const along = edges.filter(([x1, , , x2]) => x1 !== x2);
  assert.ok(along.every((edge) => edge[0] === 0 && edge[3] === 60), 'as far as the path');
  assert.ok(edges.filter(([x1, , , x2]) => x1 === x2).every(([x]) => x === 0));
  const beyond = travelEdges(travelOf([limit('x', 80, null), WHOLE[1]]), extentOf(run(WHOLE)));
  assert.ok(beyond.every((value, i) => i % 3 || value === 80), 'a path below leaves no edge along x');
});

test('fewer than two axes bound nothing', () => {
  for (const limits of [[], [WHOLE[0]], [limit('x', 0, 9), limit('y'), limit('z', null, null)]])
    assert.equal(travelOf(limits), null);
});

test('a run leaves its travel by more than its nodes may be off', () => {
  assert.equal(leavesTravel(run(WHOLE)), false);
  assert.equal(leavesTravel(run([limit('x', 0, 59.99), WHOLE[1]])), true);
  assert.equal(leavesTravel(run([limit('x', 0, 59.99), WHOLE[1]], 11)), false);
  assert.equal(leavesTravel(run([limit('x', null, 100), limit('y', 0.5, null)])), true);
  assert.equal(leavesTravel(run([limit('x', 20, 30)])), false, 'one axis alone has no box');
});
