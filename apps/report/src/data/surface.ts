// SPDX-License-Identifier: MIT
// The surface that a run leaves: heights on a grid, and the roughness of its square regions.
import { decodeColumn } from './columns.ts';
import type { SurfaceData } from './format.ts';

/** Heights and roughness, row by row from low y; x grows along a row. */
export interface DecodedSurface {
  columns: number; // of heights
  rows: number;
  spacing: number; // mm between neighbouring heights
  origin: [number, number, number]; // mm, of the first height; heights are relative to its z
  heights: Float32Array; // mm
  regionSize: number; // mm, edge of a region
  regionColumns: number;
  regionRows: number;
  rmax: Float32Array; // um by region, -1: unknown
  target: Float32Array; // um by region, -1: none
}

/** Returns the arrays of a surface. Throws a RangeError where they are cut off. */
export function decodeSurface(blob: Uint8Array, data: SurfaceData): DecodedSurface {
  return {
    columns: data.columns,
    rows: data.rows,
    spacing: data.step_mm * data.heights_step,
    origin: data.origin_mm,
    heights: Float32Array.from(decodeColumn(blob, data.heights)),
    regionSize: data.region_mm,
    regionColumns: data.region_columns,
    regionRows: data.region_rows,
    rmax: Float32Array.from(decodeColumn(blob, data.rmax_um)),
    target: Float32Array.from(decodeColumn(blob, data.target_um)),
  };
}
