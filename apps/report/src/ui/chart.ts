// SPDX-License-Identifier: MIT
// One chart: its series reduced to the pixels there are, the limits under it, the selected line.
import uPlot from 'uplot';
import { decimate, gridPlaces, type Grid } from '../data/decimation.ts';
import type { RunModel } from '../data/run_model.ts';
import type { ChartSpec, Series } from './chart_series.ts';
import { el, fill } from './dom.ts';
import { drawLimits } from './limit_strip.ts';
import * as numbers from './numbers.ts';
import type { Session } from './session.ts';

const HEIGHT = 92; // px of the plot, with its x axis
const STRIP = 10; // px
const LEFT = 58; // px of the y axis

interface Line {
  series: Series;
  run: RunModel;
  index: number; // of the run
}

export class Chart {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly spec: ChartSpec;
  private readonly place = el('div', { class: 'plot' });
  private readonly values = el('span', { class: 'values' });
  private readonly cursor = el('div', { class: 'now' });
  private plot: uPlot | null = null;
  private lines: Line[] = [];
  private grid: Grid = { from: 0, to: 1, buckets: 1 };
  private made = ''; // what the plot was made for

  constructor(session: Session, spec: ChartSpec) {
    this.session = session;
    this.spec = spec;
    this.element = el('figure', { class: 'chart', 'aria-label': `${spec.title}, ${spec.unit}` },
      el('figcaption', {}, el('b', {}, spec.title), el('span', { class: 'unit' }, spec.unit), this.values), this.place);
  }

  /** Draws all again: for another range, run, theme or size. */
  draw(): void {
    const { session } = this;
    const width = Math.floor(this.place.clientWidth);
    if (width < 100) return;
    this.lines = this.linesShown();
    const kind = [session.dark, session.axis, this.lines.map(({ index, series }) => index + series.label)].join();
    this.grid = this.gridOf(width - LEFT - 12);
    const data = this.data();
    if (!this.plot || this.made !== kind) {
      this.plot?.destroy();
      this.plot = new uPlot(this.options(width), data, this.place);
      this.plot.over.append(this.cursor);
      this.made = kind;
      this.listen(this.plot.over);
    } else {
      if (this.plot.width !== width) this.plot.setSize({ width, height: this.height });
      this.plot.setData(data, false);
      this.plot.setScale('x', { min: this.grid.from, max: this.grid.to });
    }
    this.mark();
  }

  /** Draws the marks of the selected line again. */
  repaint(): void {
    this.plot?.redraw(false);
  }

  /** Moves the line that shows the instant, and shows the values there. */
  mark(): void {
    const { session, plot } = this;
    if (!plot) return;
    const row = session.hover ?? session.row;
    const x = session.xOf(session.run, row);
    const left = plot.valToPos(x, 'x');
    this.cursor.style.transform = `translateX(${left}px)`;
    this.cursor.hidden = !(left >= 0 && left <= plot.over.clientWidth);
    fill(this.values, ...this.lines.map((line) => this.value(line, x)));
  }

  destroy(): void {
    this.plot?.destroy();
  }

  private get height(): number {
    return HEIGHT + (this.spec.strip ? STRIP + 6 : 0);
  }

  private linesShown(): Line[] {
    const { runs, shown, active } = this.session;
    const all = runs.flatMap((run, index) => this.spec.series.map((series) => ({ series, run, index })));
    return all.filter(({ series, run, index }) => (shown[index] || index === active) && run.has(series.column));
  }

  private gridOf(pixels: number): Grid {
    const { session } = this;
    const buckets = Math.max(Math.floor(pixels), 50);
    if (session.zoom) {
      const from = session.xOf(session.run, session.zoom.from);
      const to = session.xOf(session.run, session.zoom.to);
      if (to > from) return { from, to, buckets };
    }
    const ends = session.runs.filter((_, i) => session.shown[i] || i === session.active)
      .map((run) => session.xOf(run, run.lastRow));
    return { from: 0, to: Math.max(...ends) || 1, buckets };
  }

  private data(): uPlot.AlignedData {
    const { session, grid } = this;
    const columns = this.lines.map(({ series, run }) => {
      const xs = session.axis === 'length' ? run.column('s') : run.rows;
      const unit = session.axis === 'length' ? 1 : run.data.period_s;
      return decimate(xs, run.column(series.column), { ...grid, from: grid.from / unit, to: grid.to / unit },
                      series.between, series.factor, series.hidden);
    });
    return [gridPlaces(grid), ...columns];
  }

  private colour({ series, index }: Line): string {
    const { dark, runs } = this.session;
    if (runs.length < 2) return dark ? series.dark : series.light;
    const faint = series.dash ? (dark ? 'b0' : '90') : '';
    if (this.lines.filter((line) => line.index === index && !line.series.dash).length > 1)
      return (dark ? series.dark : series.light) + faint;
    return (index === 0 ? (dark ? '#56b4e9' : '#0072b2') : dark ? '#e69f00' : '#c07800') + faint;
  }

  private options(width: number): uPlot.Options {
    const { dark, axis } = this.session;
    const ink = dark ? '#a6aeb8' : '#545c66';
    const rule = { stroke: dark ? '#2b3038' : '#e8ebef', width: 1 };
    const font = '11px system-ui, sans-serif';
    const stripSize = this.spec.strip ? STRIP + 6 : 0;
    return {
      width, height: this.height, padding: [6, 12, 0, 0], legend: { show: false },
      cursor: { points: { show: false }, y: false, x: false, drag: { x: true, y: false, setScale: false } },
      scales: { x: { time: false, range: () => [this.grid.from, this.grid.to] }, y: { range: (_, low, high) => this.range(low, high) } },
      axes: [
        { stroke: ink, font, size: 22 + stripSize, gap: 2 + stripSize, ticks: { show: false }, grid: rule, space: 70,
          values: (_, ticks) => ticks.map((value, i) => axisText(value, ticks) + (i === ticks.length - 1 ? (axis === 'time' ? ' s' : ' mm') : '')) },
        { stroke: ink, font, size: LEFT, gap: 4, ticks: { show: false }, grid: rule, space: 24,
          values: (_, ticks) => ticks.map((value) => axisText(value, ticks)) }],
      series: [{}, ...this.lines.map((line): uPlot.Series => ({
        stroke: this.colour(line), width: 1.25, points: { show: false }, dash: line.series.dash ?? (line.index === 1 && this.lines.length > 3 ? [6, 2] : undefined),
      }))],
      hooks: {
        drawClear: [(plot) => this.paintSelection(plot)],
        draw: [(plot) => this.paintStrip(plot)],
        setSelect: [(plot) => this.selected(plot)],
      },
    };
  }

  private range(low: number | null, high: number | null): [number, number] {
    if (low === null || high === null) return [0, 1];
    if (this.spec.fromZero) return [0, high > 0 ? high * 1.06 : 1];
    const margin = (high - low) * 0.06 || 1;
    return [low - margin, high + margin];
  }

  private paintSelection(plot: uPlot): void {
    const { session } = this;
    const { left, top, width, height } = plot.bbox;
    plot.ctx.fillStyle = session.dark ? '#ff4aaa40' : '#ff2d9b28';
    let painted = -Infinity;
    for (const { from, to } of session.selection?.ranges ?? []) {
      const x0 = plot.valToPos(session.xOf(session.run, from), 'x', true);
      const x1 = plot.valToPos(session.xOf(session.run, to), 'x', true);
      const start = Math.max(x0, left, painted);
      const end = Math.min(Math.max(x1, x0 + 1.5), left + width);
      if (end <= start) continue;
      plot.ctx.fillRect(start, top, end - start, height);
      painted = end;
    }
  }

  private paintStrip(plot: uPlot): void {
    if (!this.spec.strip) return;
    const { session, grid } = this;
    const { left, top, width, height } = plot.bbox;
    const ratio = devicePixelRatio;
    const run = session.run;
    drawLimits(plot.ctx, run, {
      left, width, top: top + height + 3 * ratio, height: STRIP * ratio,
      rowAt: (part) => {
        const x = grid.from + part * (grid.to - grid.from);
        return session.axis === 'time' ? x / run.data.period_s : session.rowOf(run, x);
      },
    });
  }

  private selected(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width < 4) return;
    const row = (at: number) => this.session.rowOf(this.session.run, plot.posToVal(at, 'x'));
    const range = { from: row(left), to: row(left + width) };
    plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
    this.session.setZoom(range);
  }

  private listen(over: HTMLElement): void {
    const { session } = this;
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
    }, { passive: false });
  }

  private value(line: Line, x: number): HTMLElement {
    const { series, run, index } = line;
    const row = this.session.rowOf(run, x);
    const value = series.between === 'linear' ? run.valueAt(series.column, row) : run.column(series.column)[run.nodeAt(row)]!;
    const text = series.hidden && value < 0 ? '–' : axisFree(value * series.factor);
    const letter = this.session.runs.length > 1 ? `${'AB'[index]} ` : '';
    return el('span', { class: series.dash ? 'dashed' : '' }, el('i', { style: `border-color:${this.colour(line)}` }), `${letter}${series.label} `, el('b', {}, text));
  }
}

/** A tick with as many decimals as its neighbours need. */
function axisText(value: number, ticks: number[]): string {
  const step = ticks.length > 1 ? Math.abs(ticks[1]! - ticks[0]!) : Math.abs(value) || 1;
  return numbers.fixed(value, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
}

function axisFree(value: number): string {
  return Math.abs(value) >= 1000 ? numbers.count(value) : numbers.significant(value, 3);
}
