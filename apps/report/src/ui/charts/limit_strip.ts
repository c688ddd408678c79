// SPDX-License-Identifier: MIT
// Draws which limit binds, as a coloured strip along a chart.
import {lowerBound} from '../../data/bisection.ts';
import type {RunModel} from '../../data/run_model.ts';
import {limitColour} from '../common/limits.ts';

/** A strip on a canvas: its edges in device pixels, and the rows that its ends stand for. */
export interface Strip {
  left: number;
  top: number;
  width: number;
  height: number;
  rowAt: (part: number) => number;  // row at a part of the width, from 0 to 1
}

/** Draws in each pixel the limit that binds longest there; pixels outside the run stay empty. */
export function drawLimits(context: CanvasRenderingContext2D, run: RunModel, strip: Strip): void {
  const rows = run.rows;
  const limits = run.column('limit');
  const colours = run.data.limits.map(limitColour);
  const weights = new Float64Array(colours.length);
  const pixels = Math.max(Math.round(strip.width), 1);
  let from = strip.rowAt(0);
  for (let pixel = 0; pixel < pixels; ++pixel) {
    const to = strip.rowAt((pixel + 1) / pixels);
    const limit = longest(rows, limits, weights, from, to);
    if (limit >= 0) {
      context.fillStyle = colours[limit]!;
      context.fillRect(strip.left + pixel, strip.top, 1, strip.height);
    }
    from = to;
  }
}

function longest(
    rows: Float64Array, limits: Float64Array, weights: Float64Array, from: number,
    to: number): number {
  weights.fill(0);
  let best = -1;
  for (let node = Math.max(lowerBound(rows, from), 1); node < rows.length && rows[node - 1]! < to;
       ++node) {
    const limit = limits[node]!;
    weights[limit]! += Math.min(rows[node]!, to) - Math.max(rows[node - 1]!, from);
    if (best < 0 || weights[limit]! > weights[best]!) best = limit;
  }
  return best;
}
