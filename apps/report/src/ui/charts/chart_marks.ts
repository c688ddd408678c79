// SPDX-License-Identifier: MIT
// What is drawn into a chart beside its lines: the selected line of the program, and the limits.
import type uPlot from 'uplot';
import type {Grid} from '../../data/decimation.ts';
import type {Session} from '../common/session.ts';
import {drawLimits} from './limit_strip.ts';

const STRIP = 10;  // px

const STRIP_SHIFT = 4;  // px, for the letters of the runs

/** Distance of two strips, in px. */
export const STRIP_STEP = STRIP + 2;

/** Shades the stretches of the selected line. */
export function paintSelection(plot: uPlot, session: Session): void {
  const {left, top, width, height} = plot.bbox;
  plot.ctx.save();  // uPlot remembers the state it has set
  plot.ctx.fillStyle = session.dark ? '#ff4aaa40' : '#ff2d9b28';
  let painted = -Infinity;
  for (const {from, to} of session.selection?.ranges ?? []) {
    const x0 = plot.valToPos(session.xOf(session.run, from), 'x', true);
    const x1 = plot.valToPos(session.xOf(session.run, to), 'x', true);
    const start = Math.max(x0, left, painted);
    const end = Math.min(Math.max(x1, x0 + 1.5), left + width);
    if (end <= start) continue;
    plot.ctx.fillRect(start, top, end - start, height);
    painted = end;
  }
  plot.ctx.restore();
}

/** Pales what is not of the lines that are shown alone; `strips` are the px under the plot. */
export function paintOthers(plot: uPlot, session: Session, strips: number): void {
  if (!session.isPart) return;
  const {left, top, width, height} = plot.bbox;
  const {ctx} = plot;
  ctx.save();
  ctx.fillStyle = session.dark ? '#15181dc8' : '#ffffffc8';
  let end = left;
  const pale = (to: number) => {
    const until = Math.min(to, left + width);
    if (until > end) ctx.fillRect(end, top, until - end, height + strips * devicePixelRatio);
  };
  const at = (row: number) => plot.valToPos(session.xOf(session.run, row), 'x', true);
  for (const {from, to} of session.stays[session.active]!) {
    pale(at(from));
    end = Math.max(end, at(to));
  }
  pale(Infinity);
  ctx.restore();
}

/** Draws the limits of some runs under a chart, one strip for each. */
export function paintStrips(plot: uPlot, session: Session, grid: Grid, runs: number[]): void {
  const {left, top, width, height} = plot.bbox;
  const ratio = devicePixelRatio;
  plot.ctx.save();
  runs.forEach((index, place) => {
    const run = session.runs[index]!;
    const at =
        top + height + (3 + STRIP_SHIFT * Number(runs.length > 1) + place * STRIP_STEP) * ratio;
    drawLimits(plot.ctx, run, {
      left,
      width,
      top: at,
      height: STRIP * ratio,
      rowAt: (part) => {
        const x = grid.from + part * (grid.to - grid.from);
        return session.axis === 'time' ? x / run.data.period_s : session.rowOf(run, x);
      },
    });
    if (session.runs.length < 2) return;
    plot.ctx.fillStyle = session.dark ? '#a6aeb8' : '#545c66';
    plot.ctx.font = `${10 * ratio}px system-ui, sans-serif`;
    plot.ctx.textAlign = 'right';
    plot.ctx.textBaseline = 'middle';
    plot.ctx.fillText('AB'[index]!, left - 4 * ratio, at + (STRIP / 2) * ratio);
  });
  plot.ctx.restore();
}
