// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';

import {BlobWriter, randoms} from './encode.mjs';
import {load} from './load.mjs';

const {RunModel} = await load('data/run_model.ts');
const {LineIndex} = await load('data/line_index.ts');
const {ProgramText} = await load('data/program_text.ts');
const {decodeSurface} = await load('data/surface.ts');
const {drawnPath, spread} = await load('ui/pictures/path_layers.ts');
const {visibleNodes} = await load('ui/pictures/filters.ts');

const encoded = (text) => new TextEncoder().encode(text);

/** A run of 100 rows: line 2, then lines 3 and 4 five times, then line 1 of another file. */
function loops() {
  const writer = new BlobWriter();
  const starts = [0, 10, 14, 20, 24, 30, 34, 40, 44, 50, 54, 60];
  const lines = [2, 3, 4, 3, 4, 3, 4, 3, 4, 3, 4, 1];
  const files = lines.map((_, i) => (i === 11 ? 1 : 0));
  const rows = [0, 7, 10, 31, 64, 100];
  const data = {
    period_s: 0.002,
    limits: ['feed', 'acceleration'],
    diagnostics: [{file: 1, line: 9}],
    files: [
      {name: 'a.nc', text: writer.slice(encoded('G21\r\nG0 X1\nG1 X2 F100\n  g1 x3'))},
      {name: 'b.nc'}
    ],
    nodes: {
      row: writer.column(rows, 1),
      x: writer.column([0, 700, 1000, -1100, 2200, 2200], 2, 0.001),
      s: writer.column([0, 700, 1000, 3100, 6400, 6400], 2, 0.001),
    },
    spans: {
      row: writer.column(starts, 1),
      line: writer.column(lines, 1),
      file: writer.column(files, 1)
    },
    lines: {
      file: writer.column([0, 0, 0, 1], 1),
      line: writer.column([2, 3, 4, 1], 1),
      ms: writer.column([200, 400, 600, 800], 0, 0.1),
      lost_ms: writer.column([0, 10, 20, 30], 0, 0.1)
    },
  };
  return {run: new RunModel(data, writer.blob), starts, lines, files, rows};
}

test('a row belongs to the line whose stretch has begun before it', () => {
  const {run, starts, lines, files} = loops();
  for (let row = 1; row <= 100; ++row) {
    let span = 0;
    while (span + 1 < starts.length && starts[span + 1] < row) ++span;
    assert.deepEqual(run.placeAt(row), {file: files[span], line: lines[span]}, `row ${row}`);
  }
  assert.deepEqual(run.placeAt(0), {file: 0, line: 2});
});

test('the stretches of a line are those of all its rounds', () => {
  const {run} = loops();
  const of = (line, file = 0) => run.rangesOf({file, line});
  assert.deepEqual(of(3), [10, 20, 30, 40, 50].map((from) => ({from, to: from + 4})));
  assert.deepEqual(of(4), [14, 24, 34, 44, 54].map((from) => ({from, to: from + 6})));
  assert.deepEqual(of(1, 1), [{from: 60, to: 100}]);
  for (const [line, file] of [[1, 0], [5, 0], [2, 1], [1, 7]]) assert.deepEqual(of(line, file), []);
});

test('the stretches of some lines are those of all their rounds, joined where they touch', () => {
  const {run} = loops();
  const of = (first, last, file = 0) => run.rangesOfLines({file, first, last});
  assert.deepEqual(of(3, 4), [{from: 10, to: 60}]);
  assert.deepEqual(of(2, 3), [{from: 0, to: 14}, ...[20, 30, 40, 50].map((from) => ({from, to: from + 4}))]);
  assert.deepEqual(of(4, 4), run.rangesOf({file: 0, line: 4}));
  assert.deepEqual(of(1, 9, 1), [{from: 60, to: 100}]);
  assert.deepEqual(of(5, 8), []);
});

test('what some lines take is the sum of all their rounds', () => {
  const {run} = loops();
  const range = {file: 0, first: 1, last: 3};
  const {seconds, lost} = run.timeOfLines(range);
  assert.ok(Math.abs(seconds - 0.06) < 1e-12 && Math.abs(lost - 0.001) < 1e-12);
  const stays = run.rangesOfLines(range);
  const mm = stays.reduce((sum, {from, to}) => sum + run.valueAt('s', to) - run.valueAt('s', from), 0);
  assert.ok(Math.abs(run.lengthOf(stays) - mm) < 1e-12 && mm > 0);
  assert.deepEqual(run.timeOfLines({file: 0, first: 7, last: 9}), {seconds: 0, lost: 0});
});

test('a part of a path ends where its lines do', () => {
  const {run} = loops();
  const stays = run.rangesOfLines({file: 0, first: 3, last: 3});
  const path = drawnPath(run, stays);
  const {row, x} = path.layer;
  assert.deepEqual([...row], [0, 7, 10, 14, 20, 24, 30, 31, 34, 40, 44, 50, 54, 64, 100]);
  row.forEach((at, i) => assert.ok(Math.abs(x[i] - run.valueAt('x', at)) < 1e-12));
  assert.deepEqual([...spread(path, Uint8Array.from([0, 1, 2, 3, 4, 5]), 1)],
      [...row].map((at) => run.nodeAt(at)));
  const session = {shown: [true], tool: null, isPart: true, stays: [stays]};
  const visible = visibleNodes(session, run, 0, path);
  row.forEach((at, i) => i && assert.equal(
      Boolean(visible[i]), stays.some(({from, to}) => row[i - 1] >= from && at <= to), `to ${at}`));
  assert.equal(drawnPath(run, []).nodes, null);
});

test('neighbouring stretches of one line are one', () => {
  const writer = new BlobWriter();
  const data = {
    period_s: 1,
    nodes: {row: writer.column([0, 30], 1)},
    spans: {
      row: writer.column([0, 10, 20], 1),
      line: writer.column([5, 5, 6]),
      file: writer.column([0, 0, 0])
    },
  };
  assert.deepEqual(
      new RunModel(data, writer.blob).rangesOf({file: 0, line: 5}), [{from: 0, to: 20}]);
});

test('the next and the previous stretch are found in time', () => {
  const {run} = loops();
  assert.deepEqual(run.placeInTime(11, 1), {place: {file: 0, line: 4}, row: 15});
  assert.deepEqual(run.placeInTime(15, -1), {place: {file: 0, line: 3}, row: 11});
  const there = run.placeInTime(12, 1);
  const back = run.placeInTime(there.row, -1);
  assert.deepEqual([there.place.line, back.place.line, back.row], [4, 3, 11]);
  assert.equal(run.placeInTime(61, 1), null);
  assert.equal(run.placeInTime(5, -1), null);
});

test('values are linear between nodes, and lengths lead back to rows', () => {
  const {run} = loops();
  assert.equal(run.valueAt('x', 0), 0);
  assert.ok(Math.abs(run.valueAt('x', 3.5) - 0.35) < 1e-12);
  assert.ok(Math.abs(run.valueAt('x', 20.5) - (1 - 0.1 * 10.5)) < 1e-12);
  assert.ok(Math.abs(run.valueAt('x', 300) - 2.2) < 1e-12);
  for (const row of [0, 3, 7, 9.25, 30, 63.5])
    assert.ok(Math.abs(run.rowAtLength(run.valueAt('s', row)) - row) < 1e-9);
  assert.equal(run.rowAtLength(6.4), 64);  // where the rest begins
  assert.equal(run.secondsAt(50), 0.1);
  assert.equal(run.rowAtSeconds(1), 100);
  assert.deepEqual([0, 0.5, 7, 8, 100, 200].map((row) => run.nodeAt(row)), [0, 1, 1, 2, 5, 5]);
});

test('times of lines are in seconds', () => {
  const {run} = loops();
  assert.deepEqual(run.lineTime({file: 0, line: 3}), {seconds: 0.04, lost: 0.001});
  assert.equal(run.lineTime({file: 0, line: 1}), null);
  assert.equal(run.longestLine, 0.08);
});

test('a file without text has as many lines as times and diagnostics mention', () => {
  const {run} = loops();
  assert.equal(run.lineCount(0), 4);
  assert.equal(run.text(1), null);
  assert.equal(run.lineCount(1), 9);
});

test('a use of limits needs limits', () => {
  const writer = new BlobWriter();
  const nodes = Object.fromEntries(
      ['row', 'acceleration_use', 'jerk_use'].map((name) => [name, writer.column([0, 1])]));
  const known = (axis_limits) => {
    const run = new RunModel({axis_limits, nodes}, writer.blob);
    return ['acceleration_use', 'jerk_use', 'x'].map((name) => run.has(name));
  };
  assert.deepEqual(known([]), [false, false, false]);
  assert.deepEqual(known([{jerk_mm_s3: 0}]), [true, false, false]);
  assert.deepEqual(known([{jerk_mm_s3: 0}, {jerk_mm_s3: 9}]), [true, true, false]);
});

test('an empty run has no nodes, no places and no stretches', () => {
  const writer = new BlobWriter();
  const none = () => writer.column([]);
  const run = new RunModel(
      {
        period_s: 0.001,
        nodes: {row: none(), x: none()},
        files: [{name: 'a.nc'}],
        diagnostics: [],
        spans: {row: none(), line: none(), file: none()},
        lines: {file: none(), line: none(), ms: none(), lost_ms: none()},
      },
      writer.blob);
  assert.equal(run.moves, false);
  assert.equal(run.placeAt(0), null);
  assert.deepEqual(run.rangesOf({file: 0, line: 1}), []);
  assert.equal(run.lineTime({file: 0, line: 1}), null);
  assert.equal(run.valueAt('x', 3), 0);
  assert.equal(run.rowAtLength(1), 0);
});

test('the index of lines agrees with a search of all entries', () => {
  const random = randoms(7);
  const files = Array.from({length: 500}, () => (random() < 0.5 ? 0 : 3));
  const lines = files.map(() => Math.floor(random() * 40));
  const index = new LineIndex(files, lines);
  for (let file = -1; file < 6; ++file)
    for (let line = -1; line < 45; ++line)
      assert.deepEqual(
          [...index.of(file, line)],
          files.flatMap((of, i) => (of === file && lines[i] === line ? [i] : [])));
});

test('lines of a text have no ends, and may lack the last one', () => {
  const text = new ProgramText(encoded('G21\r\nG0 X1\n\n  g1 x3'));
  assert.equal(text.lines, 4);
  assert.deepEqual(
      [0, 1, 2, 3, 4, 5].map((line) => text.line(line)), ['', 'G21', 'G0 X1', '', '  g1 x3', '']);
  assert.equal(new ProgramText(encoded('a\nb\n')).lines, 2);
  assert.equal(new ProgramText(encoded('')).lines, 0);
});

test('a search goes on at the other end, and ignores case', () => {
  const text = new ProgramText(encoded('G1 X1\nG0\ng1 x2\nM2'));
  assert.equal(text.find('g1', 0), 1);
  assert.equal(text.find('G1', 1), 3);
  assert.equal(text.find('g1', 3), 1);
  assert.equal(text.find('g1', 3, true), 1);
  assert.equal(text.find('g1', 1, true), 3);
  assert.equal(text.find('X9', 1), 0);
  assert.equal(text.find('', 1), 0);
});

test('a surface keeps the distance of its heights', () => {
  const writer = new BlobWriter();
  const surface = decodeSurface(writer.blob.length ? writer.blob : new Uint8Array(0), {
    step_mm: 0.05,
    heights_step: 4,
    columns: 0,
    rows: 0,
    origin_mm: [1, 2, 3],
    heights: writer.column([]),
    region_mm: 1,
    region_columns: 0,
    region_rows: 0,
    rmax_um: writer.column([]),
    target_um: writer.column([]),
  });
  assert.equal(surface.spacing, 0.2);
  assert.equal(surface.heights.length, 0);
});
