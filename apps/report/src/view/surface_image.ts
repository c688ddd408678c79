// SPDX-License-Identifier: MIT
// Pictures of a surface: one pixel per height, or per region.

import type { DecodedSurface } from '../data/surface.ts';
import { heightColour, kMet, kMissed, kNoTarget, roughnessColour } from './colour_map.ts';
import type { Rgb } from './theme.ts';

const kWantedSlope = 0.6; // Slopes are exaggerated until their mean square root is this.
const kMostExaggeration = 400;
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

/** Returns the brightness of each height under light from the upper left, about 1. */
function shading(surface: DecodedSurface): Float32Array {
  const { columns, rows, spacing, heights } = surface;
  const slopes = new Float32Array(2 * columns * rows);
  let squares = 0;
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const at = row * columns + column;
      const left = column > 0 ? at - 1 : at, right = column < columns - 1 ? at + 1 : at;
      const below = row > 0 ? at - columns : at, above = row < rows - 1 ? at + columns : at;
      const dx = (heights[right]! - heights[left]!) / (Math.max(1, right - left) * spacing);
      const dy = (heights[above]! - heights[below]!) /
        (Math.max(1, (above - below) / columns) * spacing);
      slopes[2 * at] = dx;
      slopes[2 * at + 1] = dy;
      squares += Math.min(4, dx * dx + dy * dy);
    }
  }
  const mean = Math.sqrt(squares / Math.max(1, columns * rows));
  const factor = Math.min(kMostExaggeration, Math.max(1, kWantedSlope / Math.max(1e-9, mean)));
  const shade = new Float32Array(columns * rows);
  for (let at = 0; at < shade.length; at++) {
    const dx = slopes[2 * at]! * factor, dy = slopes[2 * at + 1]! * factor;
    const light = (-dx * kLight[0] - dy * kLight[1] + kLight[2]) / Math.sqrt(1 + dx * dx + dy * dy);
    shade[at] = 0.45 + 0.75 * Math.max(0, light);
  }
  return shade;
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
