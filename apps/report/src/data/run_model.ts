// SPDX-License-Identifier: MIT
// A run, decoded: nodes of its path and speed, and which line of the program they belong to.
import {lowerBound} from './bisection.ts';
import {decodeColumn} from './columns.ts';
import type {NodeColumn, RunData} from './format.ts';
import {LineIndex} from './line_index.ts';
import {ProgramText} from './program_text.ts';
import {decodeSurface, type DecodedSurface} from './surface.ts';

/** Rows from `from` to `to`, as times in periods. */
export interface RowRange {
  from: number;
  to: number;
}

/** A line of a file of a run; lines count from 1. */
export interface Place {
  file: number;
  line: number;
}

/** Lines of a file of a run, from the first to the last. */
export interface LineRange {
  file: number;
  first: number;
  last: number;
}

/** Time of a line in all its rounds, and what of it the programmed feed would not need, in s. */
export interface LineTime {
  seconds: number;
  lost: number;
}

export function isWithin({file, first, last}: LineRange, place: Place): boolean {
  return place.file === file && place.line >= first && place.line <= last;
}

/**
 * A run whose columns are decoded when first asked for. Values of nodes that describe an interval
 * (motion, limit, tool, uses and errors) belong to the rows after the previous node up to the node.
 */
export class RunModel {
  readonly data: RunData;
  private readonly blob: Uint8Array;
  private readonly columns = new Map<NodeColumn, Float64Array>();
  private readonly texts = new Map<number, ProgramText|null>();
  private cachedSpans?: {row: Float64Array; line: Float64Array; file: Float64Array};
  private cachedSpanIndex?: LineIndex;
  private cachedLines?:
      {ms: Float64Array; lost: Float64Array; index: LineIndex; last: number[]; longest: number};
  private cachedSurface?: DecodedSurface;

  constructor(data: RunData, blob: Uint8Array) {
    this.data = data;
    this.blob = blob;
  }

  /** Number of nodes: 0 for a program that has not moved. */
  get size(): number {
    return this.data.nodes.row?.count ?? 0;
  }

  get moves(): boolean {
    return this.size > 1;
  }

  /** The last row, which is the end of the run in periods. */
  get lastRow(): number {
    return this.size ? this.rows[this.size - 1]! : 0;
  }

  get rows(): Float64Array {
    return this.column('row');
  }

  /** Whether a column has values; the use of limits needs limits. */
  has(name: NodeColumn): boolean {
    const {axis_limits: limits} = this.data;
    if (name === 'acceleration_use' && !limits.length) return false;
    if (name === 'jerk_use' && limits.every(({jerk_mm_s3}) => !jerk_mm_s3)) return false;
    return (this.data.nodes[name]?.count ?? 0) > 0;
  }

  /** Returns a column of all nodes, in the unit of its name; zeros where the run has none. */
  column(name: NodeColumn): Float64Array {
    let values = this.columns.get(name);
    if (!values) {
      const column = this.data.nodes[name];
      values = column ? decodeColumn(this.blob, column) : new Float64Array(this.size);
      this.columns.set(name, values);
    }
    return values;
  }

  /** Returns the node that ends the interval of a row, which may have a fraction. */
  nodeAt(row: number): number {
    return Math.min(lowerBound(this.rows, row), Math.max(this.size - 1, 0));
  }

  /** Returns a column at a row, interpolated linearly between nodes. */
  valueAt(name: NodeColumn, row: number): number {
    const values = this.column(name);
    const node = this.nodeAt(row);
    if (node === 0) return values[0] ?? 0;
    const before = this.rows[node - 1]!;
    const part = Math.min((row - before) / (this.rows[node]! - before), 1);
    return values[node - 1]! + part * (values[node]! - values[node - 1]!);
  }

  /** Returns the row at which the path has a length in mm: the first one where it rests there. */
  rowAtLength(length: number): number {
    const s = this.column('s');
    const node = Math.min(lowerBound(s, length), Math.max(this.size - 1, 0));
    if (node === 0) return this.rows[0] ?? 0;
    const step = s[node]! - s[node - 1]!;
    const part = step > 0 ? Math.min((length - s[node - 1]!) / step, 1) : 0;
    return this.rows[node - 1]! + part * (this.rows[node]! - this.rows[node - 1]!);
  }

  secondsAt(row: number): number {
    return row * this.data.period_s;
  }

  rowAtSeconds(seconds: number): number {
    return Math.min(Math.max(seconds / this.data.period_s, 0), this.lastRow);
  }

  /** Returns the line that a row belongs to, or null where it belongs to none. */
  placeAt(row: number): Place|null {
    const {row: starts, line, file} = this.spans;
    if (!starts.length) return null;
    const span = Math.max(lowerBound(starts, row), 1) - 1;
    return line[span]! > 0 ? {file: file[span]!, line: line[span]!} : null;
  }

  /** Returns the stretches of a line in the order of time; neighbouring ones are one. */
  rangesOf({file, line}: Place): RowRange[] {
    this.cachedSpanIndex ??= new LineIndex(this.spans.file, this.spans.line);
    return this.stretches(this.cachedSpanIndex.of(file, line));
  }

  /** Returns all stretches of some lines, in the order of time; neighbouring ones are one. */
  rangesOfLines(range: LineRange): RowRange[] {
    const {file, line} = this.spans;
    const spans: number[] = [];
    for (let span = 0; span < line.length; ++span)
      if (isWithin(range, {file: file[span]!, line: line[span]!})) spans.push(span);
    return this.stretches(spans);
  }

  /** Joins spans, which are in the order of time. */
  private stretches(spans: Iterable<number>): RowRange[] {
    const starts = this.spans.row;
    const ranges: RowRange[] = [];
    for (const span of spans) {
      const from = starts[span]!;
      const to = span + 1 < starts.length ? starts[span + 1]! : this.lastRow;
      const last = ranges[ranges.length - 1];
      if (last && last.to >= from)
        last.to = to;
      else if (to > from)
        ranges.push({from, to});
    }
    return ranges;
  }

  /**
   * Returns the line of the stretch after or before that of a row, with the first row of it; null
   * at the ends of the run.
   */
  placeInTime(row: number, step: 1|- 1): {place: Place; row: number}|null {
    const {row: starts, line, file} = this.spans;
    const span = Math.max(lowerBound(starts, row), 1) - 1 + step;
    if (span < 0 || span >= starts.length) return null;
    return {place: {file: file[span]!, line: line[span]!}, row: starts[span]! + 1};
  }

  /** Returns what a line takes, or null for one that takes no time. */
  lineTime({file, line}: Place): LineTime|null {
    const {ms, lost, index} = this.lineTable;
    const entry = index.of(file, line)[0];
    return entry === undefined ? null : {seconds: ms[entry]! / 1e3, lost: lost[entry]! / 1e3};
  }

  /** Returns what lines take together, each in all its rounds. */
  timeOfLines({file, first, last}: LineRange): LineTime {
    const sum = {seconds: 0, lost: 0};
    for (let line = first; line <= last; ++line) {
      const time = this.lineTime({file, line});
      sum.seconds += time?.seconds ?? 0;
      sum.lost += time?.lost ?? 0;
    }
    return sum;
  }

  /** Returns the length of stretches of the path, in mm. */
  lengthOf(ranges: RowRange[]): number {
    return ranges.reduce(
        (sum, {from, to}) => sum + this.valueAt('s', to) - this.valueAt('s', from), 0);
  }

  /** The largest time of any one line, in s. */
  get longestLine(): number {
    return this.lineTable.longest;
  }

  /** Returns the text of a file, or null where the report has none. */
  text(file: number): ProgramText|null {
    let text = this.texts.get(file);
    if (text === undefined) {
      const slice = this.data.files[file]?.text;
      text = slice ? new ProgramText(this.blob.subarray(slice.offset, slice.offset + slice.bytes)) :
                     null;
      this.texts.set(file, text);
    }
    return text;
  }

  /** Returns how many lines a file has, as far as the report knows. */
  lineCount(file: number): number {
    const text = this.text(file);
    if (text) return text.lines;
    const diagnosed = this.data.diagnostics.reduce(
        (most, {file: of, line}) => (of === file ? Math.max(most, line) : most), 0);
    return Math.max(this.lineTable.last[file] ?? 0, diagnosed);
  }

  /** The surface, or null for a run without one. */
  get surface(): DecodedSurface|null {
    if (!this.data.surface) return null;
    return (this.cachedSurface ??= decodeSurface(this.blob, this.data.surface));
  }

  private get spans() {
    const {row, line, file} = this.data.spans;
    return (this.cachedSpans ??= {
      row: decodeColumn(this.blob, row),
      line: decodeColumn(this.blob, line),
      file: decodeColumn(this.blob, file),
    });
  }

  private get lineTable() {
    if (this.cachedLines) return this.cachedLines;
    const {lines} = this.data;
    const file = decodeColumn(this.blob, lines.file);
    const line = decodeColumn(this.blob, lines.line);
    const ms = decodeColumn(this.blob, lines.ms);
    const last: number[] = [];
    for (let i = 0; i < line.length; ++i) last[file[i]!] = Math.max(last[file[i]!] ?? 0, line[i]!);
    return (this.cachedLines = {
      ms,
      lost: decodeColumn(this.blob, lines.lost_ms),
      index: new LineIndex(file, line),
      last,
      longest: ms.reduce((most, one) => Math.max(most, one), 0) / 1e3,
    });
  }
}
