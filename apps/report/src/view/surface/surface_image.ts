// SPDX-License-Identifier: MIT
// Pictures of a surface: one pixel per height, or per region.

import type { DecodedSurface } from '../../data/surface.ts';
import type { Rgb } from '../common/theme.ts';
import { heightColour, kMet, kMissed, kNoTarget, roughnessColour } from './colour_map.ts';

// Slopes are exaggerated until their root mean square is this: those of the shape as a whole, and
// those of the tool's marks on it, each on its own.
const kBroadSlope = 0.25;
const kFineSlope = 0.35;
const kMostExaggeration = 400;
const kBroadReach = 6; // Heights to each side that the shape as a whole is averaged over.
const kLight: [number, number, number] = [-0.5, 0.5, 0.7071]; // From the upper left.

/** Lowest and highest of some values. */
export interface Span {
  low: number;
  high: number;
}

/** Returns the span of the values that are at least `least`; 0 to 1 where there is none. */
export function spanOf(values: Float32Array, least = -Infinity): Span {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (!(value >= least)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? { low, high } : { low: 0, high: 1 };
}

/** Whether a region meets its target; unknown where it has no roughness or no target. */
export function verdict(surface: DecodedSurface, region: number): 'met' | 'missed' | 'unknown' {
  const rmax = surface.rmax[region]!, target = surface.target[region]!;
  if (!(rmax >= 0) || !(target > 0)) return 'unknown';
  return rmax <= target ? 'met' : 'missed';
}

/** Returns the picture of the heights, shaded; its first row has the highest y. */
export function heightImage(surface: DecodedSurface, span: Span): HTMLCanvasElement {
  const { columns, rows, heights } = surface;
  const shade = shading(surface);
  const range = Math.max(1e-9, span.high - span.low);
  const table = Array.from({ length: 256 }, (_, k) => heightColour(k / 255));
  return paint(columns, rows, (column, row) => {
    const at = row * columns + column;
    const colour = table[Math.round(Math.min(1, Math.max(0, (heights[at]! - span.low) / range)) * 255)]!;
    return colour.map((c) => Math.min(255, c * shade[at]! + 12)) as Rgb;
  });
}

/** Returns the picture of the roughness of regions, one pixel each; null is transparent. */
export function roughnessImage(surface: DecodedSurface, span: Span): HTMLCanvasElement {
  return paint(surface.regionColumns, surface.regionRows, (column, row) => {
    const rmax = surface.rmax[row * surface.regionColumns + column]!;
    if (!(rmax >= 0)) return null;
    return roughnessColour((rmax - span.low) / Math.max(1e-9, span.high - span.low));
  });
}

/** Returns the picture of the regions that meet or miss their targets. */
export function verdictImage(surface: DecodedSurface): HTMLCanvasElement {
  return paint(surface.regionColumns, surface.regionRows, (column, row) => {
    const region = row * surface.regionColumns + column;
    if (!(surface.rmax[region]! >= 0)) return null;
    const found = verdict(surface, region);
    return found === 'met' ? kMet : found === 'missed' ? kMissed : kNoTarget;
  });
}

/** Returns the brightness of each height under light from the upper left, at most about 1. */
function shading(surface: DecodedSurface): Float32Array {
  const { columns, rows } = surface;
  const shade = new Float32Array(columns * rows);
  const fine = [slopes(surface, 1), slopes(surface, columns)] as const;
  const broad = fine.map((values) => average(values, columns, rows)) as [Float32Array, Float32Array];
  for (let at = 0; at < shade.length; at++) {
    for (const axis of [0, 1] as const) fine[axis][at]! -= broad[axis][at]!;
  }
  const fineFactor = exaggeration(fine, kFineSlope), broadFactor = exaggeration(broad, kBroadSlope);
  for (let at = 0; at < shade.length; at++) {
    const dx = fine[0][at]! * fineFactor + broad[0][at]! * broadFactor;
    const dy = fine[1][at]! * fineFactor + broad[1][at]! * broadFactor;
    const light = (-dx * kLight[0] - dy * kLight[1] + kLight[2]) / Math.sqrt(1 + dx * dx + dy * dy);
    shade[at] = 0.4 + 0.62 * Math.max(0, light);
  }
  return shade;
}

/** Returns the slope at each height along x (`stride` 1) or y (`stride` columns). */
function slopes(surface: DecodedSurface, stride: number): Float32Array {
  const { columns, rows, spacing, heights } = surface;
  const values = new Float32Array(columns * rows);
  for (let at = 0; at < values.length; at++) {
    const place = stride === 1 ? at % columns : Math.floor(at / columns);
    const before = place > 0 ? 1 : 0;
    const after = place < (stride === 1 ? columns : rows) - 1 ? 1 : 0;
    values[at] = (heights[at + after * stride]! - heights[at - before * stride]!) /
      (Math.max(1, before + after) * spacing);
  }
  return values;
}

/** Returns the means over squares around each value. */
function average(values: Float32Array, columns: number, rows: number): Float32Array {
  const run = (source: Float32Array, count: number, stride: number, lines: number,
    step: number): Float32Array => {
    const result = new Float32Array(source.length);
    for (let line = 0; line < lines; line++) {
      const first = line * step;
      let sum = 0, from = 0, to = 0;
      for (let k = 0; k < count; k++) {
        for (; to < count && to <= k + kBroadReach; to++) sum += source[first + to * stride]!;
        for (; from < k - kBroadReach; from++) sum -= source[first + from * stride]!;
        result[first + k * stride] = sum / (to - from);
      }
    }
    return result;
  };
  return run(run(values, columns, 1, rows, columns), rows, columns, columns, 1);
}

function exaggeration(values: readonly [Float32Array, Float32Array], wanted: number): number {
  let squares = 0;
  for (const axis of values) for (const value of axis) squares += Math.min(4, value * value);
  const mean = Math.sqrt(squares / Math.max(1, values[0].length));
  return Math.min(kMostExaggeration, Math.max(1, wanted / Math.max(1e-9, mean)));
}

function paint(columns: number, rows: number,
  colour: (column: number, row: number) => Rgb | null): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, columns);
  canvas.height = Math.max(1, rows);
  const context = canvas.getContext('2d');
  if (context === null || columns < 1 || rows < 1) return canvas;
  const image = context.createImageData(columns, rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const c = colour(column, row);
      if (c === null) continue;
      const at = 4 * ((rows - 1 - row) * columns + column);
      image.data[at] = c[0];
      image.data[at + 1] = c[1];
      image.data[at + 2] = c[2];
      image.data[at + 3] = 255;
    }
  }
  context.putImageData(image, 0, 0);
  return canvas;
}
