// SPDX-License-Identifier: MIT
// One chart: its series reduced to the pixels there are, the limits under it, the selected line.
import uPlot from 'uplot';
import {decimate, gridPlaces, type Grid} from '../../data/decimation.ts';
import type {RunModel} from '../../data/run_model.ts';
import {el, fill} from '../common/dom.ts';
import type {Session} from '../common/session.ts';
import {chartAxes, LEFT} from './chart_axes.ts';
import {paintOthers, paintSelection, paintStrips, STRIP_STEP} from './chart_marks.ts';
import type {ChartSpec, Series} from './chart_series.ts';
import {axisFree} from './tick_texts.ts';

const HEIGHT = 92;  // px of the plot, with its x axis

interface Line {
  series: Series;
  run: RunModel;
  index: number;  // of the run
}

export class Chart {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly spec: ChartSpec;
  private readonly place = el('div', {class: 'plot'});
  private readonly values = el('span', {class: 'values'});
  private readonly cursor = el('div', {class: 'now'});
  private plot: uPlot|null = null;
  private lines: Line[] = [];
  private grid: Grid = {from: 0, to: 1, buckets: 1};
  private plotted: uPlot.AlignedData = [[]];
  private readonly cut = el('span', {class: 'unit', hidden: true}, '(rapids are cut off)');
  private width = 0;  // px of the plot without its axes
  private made = '';  // what the plot was made for

  constructor(session: Session, spec: ChartSpec) {
    this.session = session;
    this.spec = spec;
    this.element =
        el('figure', {class: 'chart', 'aria-label': `${spec.title}, ${spec.unit}`},
           el('figcaption', {}, el('b', {}, spec.title), el('span', {class: 'unit'}, spec.unit),
              this.cut, this.values),
           this.place);
  }

  /** Draws all again: for another range, run, theme or size. */
  draw(): void {
    const {session} = this;
    const width = Math.floor(this.place.clientWidth);
    if (width < 100) return;
    this.lines = this.linesShown();
    const kind = [
      session.dark, session.axis, this.lines.map(({index, series}) => index + series.label)
    ].join();
    this.grid = this.gridOf(width - LEFT - 12);
    const data = (this.plotted = this.data());
    if (!this.plot || this.made !== kind) {
      this.plot?.destroy();
      this.plot = new uPlot(this.options(width), data, this.place);
      this.plot.over.append(this.cursor);
      this.made = kind;
      this.listen(this.plot.over);
    } else {
      if (this.plot.width !== width) this.plot.setSize({width, height: this.height});
      this.plot.setData(data, false);
      this.plot.setScale('x', {min: this.grid.from, max: this.grid.to});
    }
    this.width = this.plot.over.clientWidth;
    this.moveCursor();
    this.showValues();
  }

  /** Draws the marks of the selected line again. */
  repaint(): void {
    this.plot?.redraw(false);
  }

  /** Moves the line that shows the instant. */
  moveCursor(): void {
    if (!this.plot) return;
    const {from, to} = this.grid;  // the plot takes over a new range later
    const left = ((this.instant() - from) / (to - from)) * this.width;
    this.cursor.hidden = !(left >= 0 && left <= this.width);
    this.cursor.style.transform = `translateX(${left.toFixed(1)}px)`;
  }

  /** Shows the values at the instant. */
  showValues(): void {
    const x = this.instant();
    fill(this.values, ...this.lines.map((line) => this.value(line, x)));
  }

  /** What the cursor is at: s or mm. */
  private instant(): number {
    const {session} = this;
    return session.xOf(session.run, session.hover ?? session.row);
  }

  destroy(): void {
    this.plot?.destroy();
  }

  private get height(): number {
    return HEIGHT + this.stripSize;
  }

  private linesShown(): Line[] {
    const {runs, shown, active} = this.session;
    const all =
        runs.flatMap((run, index) => this.spec.series.map((series) => ({series, run, index})));
    return all.filter(
        ({series, run, index}) => (shown[index] || index === active) && run.has(series.column));
  }

  private gridOf(pixels: number): Grid {
    const {session} = this;
    const buckets = Math.max(Math.floor(pixels), 50);
    if (session.zoom) {
      const from = session.xOf(session.run, session.zoom.from);
      const to = session.xOf(session.run, session.zoom.to);
      if (to > from) return {from, to, buckets};
    }
    const ends = session.runs.filter((_, i) => session.shown[i] || i === session.active)
                     .map((run) => session.xOf(run, run.lastRow));
    return {from: 0, to: Math.max(...ends) || 1, buckets};
  }

  private data(): uPlot.AlignedData {
    const {session, grid} = this;
    const columns = this.lines.map(({series, run}) => {
      const xs = session.axis === 'length' ? run.column('s') : run.rows;
      const unit = session.axis === 'length' ? 1 : run.data.period_s;
      return decimate(
          xs, run.column(series.column), {...grid, from: grid.from / unit, to: grid.to / unit},
          series.between, series.factor, series.lowest);
    });
    return [gridPlaces(grid), ...columns];
  }

  private colour({series, index}: Line): string {
    const {dark, runs} = this.session;
    if (runs.length < 2) return dark ? series.dark : series.light;
    const faint = series.dash ? (dark ? 'b0' : '90') : '';
    if (this.solid(index) > 1) return (dark ? series.dark : series.light) + faint;
    return (index === 0 ? (dark ? '#56b4e9' : '#0072b2') : dark ? '#e69f00' : '#c07800') + faint;
  }

  /** Number of series of a run that are drawn as full lines. */
  private solid(run: number): number {
    return this.lines.filter(({index, series}) => index === run && !series.dash).length;
  }

  private options(width: number): uPlot.Options {
    const {session} = this;
    const {dark, axis} = session;
    return {
      width,
      height: this.height,
      padding: [6, 12, 0, 0],
      legend: {show: false},
      cursor:
          {points: {show: false}, y: false, x: false, drag: {x: true, y: false, setScale: false}},
      scales: {
        x: {time: false, range: () => [this.grid.from, this.grid.to]},
        y: {range: (_, low, high) => this.range(low, high)}
      },
      axes: chartAxes(axis, this.grid.to - this.grid.from, this.stripSize, dark),
      series: [{}, ...this.lines.map((line) => this.look(line))],
      hooks: {
        drawClear: [(plot) => paintSelection(plot, session)],
        draw: [
          (plot) => paintStrips(plot, session, this.grid, this.strips()),
          (plot) => paintOthers(plot, session, this.stripSize)
        ],
        setSelect: [(plot) => this.selected(plot)],
      },
    };
  }

  private look(line: Line): uPlot.Series {
    return {
      stroke: this.colour(line),
      width: 1.25,
      points: {show: false},
      dash: line.series.dash ?? (line.index === 1 && this.solid(1) > 1 ? [6, 2] : undefined),
    };
  }

  private range(low: number|null, high: number|null): [number, number] {
    if (low === null || high === null) return [0, 1];
    const cutting = this.spec.strip ? this.fastestFeed() : 0;
    this.cut.hidden = !(cutting > 0 && high > 1.12 * cutting);
    if (cutting > 0) return [0, 1.12 * cutting];
    if (this.spec.fromZero) return [0, Math.max(high, this.spec.least ?? 0) * 1.06 || 1];
    const margin = (high - low) * 0.06 || 1;
    return [low - margin, high + margin];
  }

  /** The largest programmed feed that is shown: rapids may be much faster. */
  private fastestFeed(): number {
    let most = 0;
    this.lines.forEach(({series}, i) => {
      if (series.column === 'feed')
        for (const value of this.plotted[i + 1] ?? []) most = Math.max(most, value ?? 0);
    });
    return most;
  }

  /** Runs whose limits are drawn under the chart. */
  private strips(): number[] {
    const {runs, shown, active} = this.session;
    return this.spec.strip ? [...runs.keys()].filter((i) => shown[i] || i === active) : [];
  }

  private get stripSize(): number {
    const strips = this.strips().length;
    return strips ? strips * STRIP_STEP + (strips > 1 ? 8 : 4) : 0;
  }

  private selected(plot: uPlot): void {
    const {left, width} = plot.select;
    if (width < 4) return;
    const row = (at: number) => this.session.rowOf(this.session.run, plot.posToVal(at, 'x'));
    const range = {from: row(left), to: row(left + width)};
    plot.setSelect({left: 0, width: 0, top: 0, height: 0}, false);
    this.session.setZoom(range);
  }

  private listen(over: HTMLElement): void {
    const {session} = this;
    const rowAt = (event: MouseEvent) => {
      const x = this.plot!.posToVal(event.clientX - over.getBoundingClientRect().left, 'x');
      return session.rowOf(session.run, x);
    };
    let pressed = 0;
    over.addEventListener('pointermove', (event) => session.setHover(rowAt(event)));
    over.addEventListener('pointerleave', () => session.setHover(null));
    over.addEventListener('pointerdown', (event) => (pressed = event.clientX));
    over.addEventListener('click', (event) => {
      if (Math.abs(event.clientX - pressed) < 4) session.selectAt(rowAt(event));
    });
    over.addEventListener('dblclick', () => session.setZoom(null));
    over.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !event.shiftKey) return;
      event.preventDefault();
      session.zoomBy(event.deltaY + event.deltaX > 0 ? 1.25 : 0.8, rowAt(event));
    }, {passive: false});
  }

  private value(line: Line, x: number): HTMLElement {
    const {series, run, index} = line;
    const row = this.session.rowOf(run, x);
    const value = series.between === 'linear' ? run.valueAt(series.column, row) :
                                                run.column(series.column)[run.nodeAt(row)]!;
    const text = series.lowest !== undefined && value < series.lowest ?
        '–' :
        axisFree(value * series.factor);
    const letter = this.session.runs.length > 1 ? `${'AB'[index]} ` : '';
    return el(
        'span', {class: series.dash ? 'dashed' : ''},
        el('i', {style: `border-color:${this.colour(line)}`}), `${letter}${series.label} `,
        el('b', {}, text));
  }
}
