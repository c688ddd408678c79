// SPDX-License-Identifier: MIT
// The numbers of a surface as texts: of its regions, and of what is under the pointer.

import type { DecodedSurface } from '../../data/surface.ts';
import { fixed } from '../common/scales.ts';

/** Returns the numbers at a place in mm from the surface's corner, or null where it is outside. */
export function readout(s: DecodedSurface, x: number, y: number): string | null {
  const column = Math.round(x / s.spacing), row = Math.round(y / s.spacing);
  if (column < 0 || row < 0 || column >= s.columns || row >= s.rows) return null;
  const parts = [`X ${fixed(x + s.origin[0], 2)}  Y ${fixed(y + s.origin[1], 2)} mm`,
    `height ${fixed(s.heights[row * s.columns + column]! + s.origin[2], 4)} mm`];
  const region = Math.floor(x / s.regionSize) + Math.floor(y / s.regionSize) * s.regionColumns;
  const inside = x < s.regionColumns * s.regionSize && y < s.regionRows * s.regionSize;
  if (inside && s.rmax[region]! >= 0) {
    const target = s.target[region]!;
    parts.push(`Rmax ${micrometres(s.rmax[region]!)}` +
      (target > 0 ? ` (target ${micrometres(target)})` : ''));
  }
  return parts.join('   ');
}

/** Returns a length with its unit, to at most two decimals. */
export function micrometres(um: number): string {
  return `${um >= 100 ? um.toFixed(0) : um >= 10 ? um.toFixed(1) : um.toFixed(2)} \u00b5m`;
}
