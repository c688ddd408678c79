// SPDX-License-Identifier: MIT
// What is shown at the moment, and who wants to know of its changes.
import type {ReportData} from '../../data/format.ts';
import {isWithin, RunModel, type LineRange, type Place, type RowRange} from '../../data/run_model.ts';
import type {QuantityId} from './quantities.ts';

export type Topic =
    |'run'|'selection'|'lines'|'row'|'hover'|'zoom'|'axis'|'colour'|'filter'|'theme'|'tab'|
    'playing';
export type ChartAxis = 'time'|'length';
export type TabId =|'summary'|'program'|'messages'|'compare'|'whatif'|'surface'|'details';

/** A line with the stretches of the path that belong to it. */
export interface Selection extends Place {
  ranges: RowRange[];
}

/** The state of the page. Change it by its functions only: they notify. */
export class Session {
  readonly report: ReportData;
  readonly runs: RunModel[];
  active = 0;
  shown: boolean[];
  selection: Selection|null = null;
  lines: LineRange|null = null;  // that are shown alone
  stays: RowRange[][] = [];      // of each run: the stretches of these lines
  row = 0;                     // where the player is, in rows of the active run
  hover: number|null = null;   // row under the pointer
  zoom: RowRange|null = null;  // rows that the charts show; null: all
  axis: ChartAxis = 'time';
  quantity: QuantityId = 'ratio';
  tool: number|null = null;
  limit: string|null = null;
  dark = false;
  playing = false;
  tab: TabId = 'summary';
  private readonly listeners = new Map<Topic, Array<() => void>>();

  constructor(report: ReportData, blob: Uint8Array) {
    this.report = report;
    this.runs = report.runs.map((run) => new RunModel(run, blob));
    this.shown = this.runs.map(() => true);
  }

  get run(): RunModel {
    return this.runs[this.active]!;
  }

  on(topics: Topic[], listener: () => void): void {
    for (const topic of topics)
      this.listeners.set(topic, [...(this.listeners.get(topic) ?? []), listener]);
  }

  private emit(topic: Topic): void {
    for (const listener of this.listeners.get(topic) ?? []) listener();
  }

  /**
   * Selects a line, or nothing; `row` is where on it, otherwise its first row. All lines are shown
   * again if it is none of those that are shown alone.
   */
  select(place: Place|null, row?: number): void {
    if (place && this.lines && !isWithin(this.lines, place)) this.setLines(null);
    this.selection = place && {...place, ranges: this.run.rangesOf(place)};
    this.emit('selection');
    const first = this.selection?.ranges[0];
    if (row !== undefined)
      this.moveTo(row);
    else if (first)
      this.moveTo(Math.min(first.from + 1, first.to));  // its first row
  }

  selectAt(row: number): void {
    this.select(this.run.placeAt(row), row);
  }

  /** Whether only some lines are shown, and there is something of them to show. */
  get isPart(): boolean {
    return this.stays.some(({length}) => length);
  }

  /** Shows these lines alone, whichever of their ends is the first; null shows all. */
  setLines(range: LineRange|null): void {
    if (!range && !this.lines) return;
    this.lines = range && {
      file: range.file,
      first: Math.min(range.first, range.last),
      last: Math.max(range.first, range.last)
    };
    const {lines} = this;
    this.stays = lines ? this.runs.map((run) => run.rangesOfLines(lines)) : [];
    if (this.selection) {
      this.selection = null;
      this.emit('selection');
    }
    this.emit('lines');
    this.zoomToLines();
  }

  /** Zooms to the lines that are shown alone, and goes to their first row. */
  private zoomToLines(): void {
    const stays = this.stays[this.active] ?? [];
    const first = stays[0];
    this.setZoom(first ? {from: first.from, to: stays[stays.length - 1]!.to} : null);
    if (first) this.moveTo(Math.min(first.from + 1, first.to));
  }

  moveTo(row: number): void {
    this.row = Math.min(Math.max(row, 0), this.run.lastRow);
    this.followRow();
    this.emit('row');
  }

  /** Moves what the charts show on when the player leaves it. */
  private followRow(): void {
    if (!this.zoom || (this.row >= this.zoom.from && this.row <= this.zoom.to)) return;
    const length = this.zoom.to - this.zoom.from;
    const from = Math.min(
        Math.max(this.row - length * (this.row > this.zoom.to ? 0.1 : 0.9), 0),
        this.run.lastRow - length);
    this.setZoom({from, to: from + length});
  }

  setHover(row: number|null): void {
    if (this.hover === row) return;
    this.hover = row;
    this.emit('hover');
  }

  setZoom(range: RowRange|null): void {
    const last = this.run.lastRow;
    const from = range ? Math.max(range.from, 0) : 0;
    const to = range ? Math.min(range.to, last) : last;
    this.zoom = range && to - from >= 2 && (from > 0 || to < last) ? {from, to} : null;
    this.emit('zoom');
  }

  /** Makes the shown part `factor` times as long, around a row. */
  zoomBy(factor: number, around: number): void {
    const {from, to} = this.zoom ?? {from: 0, to: this.run.lastRow};
    this.setZoom({from: around - (around - from) * factor, to: around + (to - around) * factor});
  }

  setAxis(axis: ChartAxis): void {
    this.axis = axis;
    this.emit('axis');
  }

  setQuantity(quantity: QuantityId): void {
    this.quantity = quantity;
    this.emit('colour');
  }

  setTool(tool: number|null): void {
    this.tool = tool;
    this.emit('filter');
  }

  setLimit(limit: string|null): void {
    this.limit = limit;
    this.emit('filter');
  }

  setShown(shown: boolean[]): void {
    this.shown = shown;
    this.emit('filter');
  }

  setActive(run: number): void {
    this.active = run;
    this.zoom = null;
    this.hover = null;
    this.row = Math.min(this.row, this.run.lastRow);
    const place = this.selection;
    this.selection = place && {...place, ranges: this.run.rangesOf(place)};
    this.emit('run');
    this.emit('selection');
    this.emit('row');
    if (this.lines) this.zoomToLines();
  }

  setDark(dark: boolean): void {
    this.dark = dark;
    this.emit('theme');
  }

  setPlaying(playing: boolean): void {
    this.playing = playing;
    this.emit('playing');
  }

  show(tab: TabId): void {
    this.tab = tab;
    this.emit('tab');
  }

  /** The x value of a chart at a row of a run: s or mm. */
  xOf(run: RunModel, row: number): number {
    return this.axis === 'time' ? run.secondsAt(row) : run.valueAt('s', row);
  }

  rowOf(run: RunModel, x: number): number {
    return this.axis === 'time' ? run.rowAtSeconds(x) : run.rowAtLength(x);
  }
}
