// SPDX-License-Identifier: MIT
// All charts of the runs, over time or over length, with one cursor and one zoom for all.
import {checkbox, Choice, drop, el, fill} from '../common/dom.ts';
import {Pace} from '../common/pace.ts';
import type {ChartAxis, Session} from '../common/session.ts';
import {Chart} from './chart.ts';
import {chartsOf, type ChartSpec} from './chart_series.ts';

const OPEN = 3;  // charts that are shown at first

export class Charts {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly stack = el('div', {class: 'stack'});
  private readonly specs: ChartSpec[];
  private readonly open: Set<string>;
  private charts: Chart[] = [];
  private readonly axis: Choice;
  private readonly texts = new Pace(() => this.charts.forEach((chart) => chart.showValues()));
  private started = false;
  private redraw = 0;

  constructor(session: Session) {
    this.session = session;
    this.specs = chartsOf(session.runs);
    this.open = new Set(this.specs.slice(0, OPEN).map(({id}) => id));
    this.axis = new Choice(
        'Charts over', [['time', 'Time'], ['length', 'Length']], session.axis,
        (axis) => session.setAxis(axis as ChartAxis));
    this.element =
        el('section', {class: 'charts', 'aria-label': 'Charts'}, this.tools(), this.stack);
    session.on(['run', 'filter', 'theme', 'axis', 'zoom', 'lines'], () => this.later());
    session.on(['axis'], () => this.axis.press(session.axis));
    session.on(['selection'], () => this.charts.forEach((chart) => chart.repaint()));
    session.on(['row', 'hover'], () => {
      this.charts.forEach((chart) => chart.moveCursor());
      this.texts.request();
    });
    new ResizeObserver(() => this.later()).observe(this.stack);
  }

  start(): void {
    if (!this.session.runs.some(({moves}) => moves)) return;
    this.started = true;
    this.build();
  }

  /** Shows only the stretches of the selected lines, with some of what is around them. */
  zoomToSelection(): void {
    const {selection, stays, active} = this.session;
    const ranges = selection?.ranges ?? stays[active];
    if (!ranges?.length) return;
    const from = ranges[0]!.from;
    const to = ranges[ranges.length - 1]!.to;
    const margin = Math.max((to - from) * 0.05, 2);
    this.session.setZoom({from: from - margin, to: to + margin});
  }

  private tools(): HTMLElement {
    const {session} = this;
    const around = () => session.hover ?? session.row;
    const button = (text: string, title: string, onclick: () => void) =>
        el('button', {type: 'button', title, 'aria-label': title, onclick}, text);
    const boxes =
        this.specs.map(({id, title}) => checkbox(this.open.has(id), () => this.toggle(id), title));
    return el(
        'div', {class: 'tools'}, this.axis.element,
        button('+', 'Zoom in (+)', () => session.zoomBy(0.5, around())),
        button('−', 'Zoom out (−)', () => session.zoomBy(2, around())),
        button('All', 'Show the whole run (0)', () => session.setZoom(null)),
        button('Line', 'Zoom to the selected line (z)', () => this.zoomToSelection()),
        drop('Charts', ...boxes));
  }

  private toggle(id: string): void {
    if (this.open.has(id))
      this.open.delete(id);
    else
      this.open.add(id);
    this.build();
  }

  /** Draws once per frame, however often something changes. */
  private later(): void {
    if (!this.started || this.redraw) return;
    this.redraw = requestAnimationFrame(() => {
      this.redraw = 0;
      for (const chart of this.charts) chart.draw();
    });
  }

  private build(): void {
    for (const chart of this.charts) chart.destroy();
    const shown = this.specs.filter(({id}) => this.open.has(id));
    this.charts = shown.map((spec) => new Chart(this.session, spec));
    fill(
        this.stack, ...this.charts.map(({element}) => element),
        !shown.length && el('p', {class: 'empty'}, 'No chart is chosen.'));
    for (const chart of this.charts) chart.draw();
  }
}
