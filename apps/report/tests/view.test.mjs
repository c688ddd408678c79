// SPDX-License-Identifier: MIT
// The view of a path, without a browser: camera, levels of detail and picking.
import assert from 'node:assert/strict';
import test from 'node:test';

import { randoms } from './encode.mjs';
import { load } from './load.mjs';

const { Camera } = await load('view/common/camera.ts');
const { codeOfError } = await load('view/levels/codes.ts');
const { PathLevels } = await load('view/levels/levels.ts');
const { pick, positionAtRow } = await load('view/levels/picking.ts');
const { addCells, chooseCode, kBegins, kMostNodes, markCells, StripBuilder } =
  await load('view/levels/strips.ts');
const { label, lengthText, niceStep } = await load('view/common/scales.ts');

/** Returns a layer of passes over a wavy surface. */
function wavy(count) {
  const layer = {
    x: new Float64Array(count), y: new Float64Array(count), z: new Float64Array(count),
    row: new Float64Array(count), motion: new Uint8Array(count).fill(1),
  };
  for (let i = 0; i < count; i++) {
    const pass = Math.floor(i / 500), part = (i % 500) / 499;
    layer.x[i] = 1000 + 100 * (pass % 2 ? 1 - part : part);
    layer.y[i] = 500 + 0.2 * pass;
    layer.z[i] = 3 * Math.sin(layer.x[i] / 9) * Math.cos(layer.y[i] / 11);
    layer.row[i] = 4 * i;
  }
  layer.motion[0] = 0;
  return layer;
}

function camera(mode = '2d', width = 800, height = 600) {
  const made = new Camera();
  Object.assign(made, { mode, width, height });
  return made;
}

const kNoInsets = { left: 0, right: 0, top: 0, bottom: 0 };

/** Returns the distance of a point from a segment in space. */
function distance(p, a, b) {
  const u = a.map((v, k) => b[k] - v), w = a.map((v, k) => p[k] - v);
  const uu = u.reduce((sum, v) => sum + v * v, 0);
  const t = uu > 0 ? Math.min(1, Math.max(0, u.reduce((sum, v, k) => sum + v * w[k], 0) / uu)) : 0;
  return Math.hypot(...w.map((v, k) => v - t * u[k]));
}

test('zooming keeps the point under the pointer, and a fitted box fills the picture', () => {
  for (const mode of ['2d', '3d']) {
    const shown = camera(mode);
    const box = { low: [-50, -20, -5], high: [50, 20, 5] };
    shown.fit(box, { left: 60, right: 10, top: 20, bottom: 30 });
    const corners = Array.from({ length: 8 }, (_, k) => shown.project(
      k & 1 ? 50 : -50, k & 2 ? 20 : -20, k & 4 ? 5 : -5));
    const [xs, ys] = [0, 1].map((axis) => corners.map((corner) => corner[axis]));
    const edges = [Math.min(...xs) - 60, 790 - Math.max(...xs), Math.min(...ys) - 20,
      570 - Math.max(...ys)];
    assert.ok(edges.every((free) => free > -1e-6), `${mode}: ${edges}`);
    assert.ok(Math.min(edges[0] + edges[1], edges[2] + edges[3]) < 1e-6);
    const before = shown.project(12, -7, 3);
    shown.zoomAt(3.7, ...before);
    const after = shown.project(12, -7, 3);
    assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 1e-6);
  }
});

test('the directions of the screen are perpendicular and of length 1 however it is turned', () => {
  const shown = camera('3d');
  const random = randoms(3);
  for (let k = 0; k < 50; k++) {
    shown.rotate(400 * (random() - 0.5), 400 * (random() - 0.5));
    const { right, up, towards } = shown.basis();
    const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
    for (const [a, b, wanted] of [[right, right, 1], [up, up, 1], [towards, towards, 1],
      [right, up, 0], [right, towards, 0], [up, towards, 0]]) {
      assert.ok(Math.abs(dot(a, b) - wanted) < 1e-12);
    }
  }
});

test('a side shows the faces that it looks along as lines', () => {
  const shown = camera('2d');
  const seen = (side) => {
    shown.lookFrom(side);
    return [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => shown.project(...axis))
      .map(([x, y]) => [x - 400, 300 - y]);
  };
  assert.deepEqual(seen('top'), [[1, 0], [0, 1], [0, 0]]);
  assert.deepEqual(seen('front'), [[1, 0], [0, 0], [0, 1]]);
  assert.deepEqual(seen('right'), [[0, 0], [1, 0], [0, 1]]);
  const lengths = seen('isometric').map(([x, y]) => Math.hypot(x, y));
  lengths.forEach((length) => assert.ok(Math.abs(length - Math.sqrt(2 / 3)) < 1e-12));
  assert.deepEqual(shown.basis().towards.map(Math.sign), [1, -1, 1]);
  assert.equal(shown.mode, '3d');
});

test('what is left out of a level lies within its error of what is drawn', () => {
  const layer = wavy(3000);
  const path = new PathLevels(layer, [1050, 500, 0]);
  path.setColours(new Uint8Array(3 * 3000).fill(90));
  path.rank();
  const at = (i) => [layer.x[i], layer.y[i], layer.z[i]];
  let dropped = 0;
  for (const error of [0.001, 0.01, 0.1, 1]) {
    const code = codeOfError(error) + 1;
    let from = 0;
    for (let i = 1; i < 3000; i++) {
      if (path.code[i] < code && i < 2999) continue;
      for (let j = from + 1; j < i; j++, dropped++) {
        const off = distance(at(j), at(from), at(i));
        // A code stands for errors up to a step of sqrt(2); positions are float32.
        assert.ok(off <= error * Math.SQRT2 + 1e-5, `node ${j} is ${off} mm off at ${error} mm`);
      }
      from = i;
    }
  }
  assert.ok(dropped > 3000);
});

test('a picture of 250,000 nodes is within the budget, and a part of it is drawn in full', () => {
  const count = 250000;
  const path = new PathLevels(wavy(count), [1050, 550, 0]);
  const random = randoms(5);
  path.setColours(Uint8Array.from({ length: 3 * count }, () => 256 * random()));
  path.setFlat(true);
  path.rank();
  const shown = camera('2d');
  const marks = new Uint8Array(path.cells);
  const draw = () => {
    markCells(path, shown, marks);
    const code = chooseCode([path], [marks], shown.scale, kMostNodes);
    const builder = new StripBuilder(kMostNodes);
    return { code, all: addCells(builder, path, marks, code), strips: builder.strips };
  };
  shown.fit(path.drawnBox(), kNoInsets);
  const whole = draw();
  assert.ok(whole.strips.count > kMostNodes / 4 && whole.strips.count <= kMostNodes);
  shown.zoomAt(300, 400, 300);
  const part = draw();
  assert.ok(part.all);
  const drawnNodes = new Set();
  for (let i = 0; i < part.strips.count; i++) {
    drawnNodes.add(part.strips.position.slice(3 * i, 3 * i + 3).join());
  }
  let seen = 0;
  for (let i = 0; i < count; i++) {
    const [x, y] = shown.project(...path.position.slice(3 * i, 3 * i + 3));
    if (x < 0 || y < 0 || x > 800 || y > 600) continue;
    seen++;
    assert.ok(drawnNodes.has(path.position.slice(3 * i, 3 * i + 3).join()), `node ${i}`);
  }
  assert.ok(seen > 0, 'the part has nodes');
});

test('one interval of another colour is seen in the picture of the whole', () => {
  const count = 100000;
  const path = new PathLevels(wavy(count), [1050, 520, 0]);
  const rgb = new Uint8Array(3 * count).fill(120);
  rgb.set([255, 0, 0], 3 * 43210);
  path.setColours(rgb);
  path.setFlat(true);
  path.rank();
  const shown = camera('2d');
  shown.fit(path.drawnBox(), kNoInsets);
  const marks = new Uint8Array(path.cells);
  markCells(path, shown, marks);
  const builder = new StripBuilder(kMostNodes);
  addCells(builder, path, marks, chooseCode([path], [marks], shown.scale, kMostNodes / 8));
  const { strips } = builder;
  const reds = [];
  for (let i = 0; i < strips.count; i++) {
    if (strips.look[4 * i] === 255 && !(strips.look[4 * i + 3] & kBegins)) reds.push(i);
  }
  assert.equal(reds.length, 1);
  const [x, y] = shown.project(...strips.position.slice(3 * reds[0], 3 * reds[0] + 3));
  const [wantedX, wantedY] = shown.project(...path.position.slice(3 * 43210, 3 * 43210 + 3));
  assert.ok(Math.hypot(x - wantedX, y - wantedY) < 60, 'at its place');
});

test('hidden intervals and rests are not drawn', () => {
  const layer = wavy(600);
  const path = new PathLevels(layer, [0, 0, 0]);
  const visible = new Uint8Array(600).fill(1);
  visible.fill(0, 100, 300);
  path.setVisible(visible);
  path.rank();
  const builder = new StripBuilder(5000);
  addCells(builder, path, new Uint8Array(path.cells).fill(1), 1);
  const { strips } = builder;
  for (let i = 0; i < strips.count; i++) {
    const row = [...layer.x.keys()].find((k) => Math.abs(layer.x[k] - strips.position[3 * i]) < 1e-3 &&
      Math.abs(layer.y[k] - strips.position[3 * i + 1]) < 1e-3);
    assert.ok(row <= 99 || row >= 299, `node ${row}`);
  }
  const begins = [...Array(strips.count).keys()].filter((i) => strips.look[4 * i + 3] & kBegins);
  assert.equal(begins.length, 2);
});

test('the nearest place of the path is picked, as a search of all intervals finds it', () => {
  const layer = wavy(5000);
  const path = new PathLevels(layer, [1050, 501, 0]);
  const random = randoms(7);
  for (const mode of ['2d', '3d']) {
    const shown = camera(mode);
    shown.fit(path.drawnBox(), kNoInsets);
    shown.zoomAt(4, 400, 300);
    let hits = 0;
    for (let k = 0; k < 60; k++) {
      const [x, y] = [800 * random(), 300 + 150 * (random() - 0.5)];
      let least = Infinity;
      for (let i = 1; i < 5000; i++) {
        const [a, b] = [i - 1, i].map((j) =>
          [...shown.project(...path.position.slice(3 * j, 3 * j + 3)), 0]);
        least = Math.min(least, distance([x, y, 0], a, b));
      }
      const hit = pick([path], shown, x, y);
      assert.equal(hit !== null, least <= 10, `${least} px away`);
      if (hit === null) continue;
      hits++;
      const [hx, hy] = shown.project(...positionAtRow(path, hit.row));
      assert.ok(Math.hypot(hx - x, hy - y) <= least + 3.1, 'one of the nearest is picked');
    }
    assert.ok(hits > 5, `${hits} hits`);
  }
});

test('positions are interpolated by row', () => {
  const layer = wavy(10);
  const path = new PathLevels(layer, [1000, 500, 0]);
  const [x] = positionAtRow(path, 10);
  assert.ok(Math.abs(x - (layer.x[2] + 0.5 * (layer.x[3] - layer.x[2]) - 1000)) < 1e-4);
  assert.ok(Math.abs(positionAtRow(path, 1e9)[0] - (layer.x[9] - 1000)) < 1e-4);
});

test('steps of scales are 1, 2 or 5, and labels have the digits that they need', () => {
  assert.deepEqual([0.7, 1, 1.3, 3, 6, 0.0012].map(niceStep), [1, 1, 2, 5, 10, 0.002]);
  assert.equal(label(-0.30000000000000004, 0.1), '\u22120.3');
  assert.equal(label(-1e-12, 0.5), '0.0');
  assert.equal(label(1500, 500), '1500');
  assert.equal(lengthText(299.80001), '299.8');
});
