// SPDX-License-Identifier: MIT
// Thin outlines beside the paths: the travel of a machine, and workpieces.

import type { Box, Camera, Vector } from '../common/camera.ts';
import { css, type Theme } from '../common/theme.ts';
import type { Outline } from '../levels/path_types.ts';
import type { Labels } from './labels.ts';

const kDashes = { travel: [10, 3, 2, 3], workpiece: [] };

/** Returns the box of outlines from `centre`; null if there are none. */
export function boxOfOutlines(outlines: Outline[], centre: Vector): Box | null {
  const low: Vector = [Infinity, Infinity, Infinity];
  const high: Vector = [-Infinity, -Infinity, -Infinity];
  for (const { edges } of outlines) {
    for (let i = 0; i < edges.length; i++) {
      const axis = i % 3, value = edges[i]! - centre[axis]!;
      low[axis] = Math.min(low[axis]!, value);
      high[axis] = Math.max(high[axis]!, value);
    }
  }
  return low[0] <= high[0] ? { low, high } : null;
}

/** Adds a line; one along the rows or columns of pixels is moved onto them, to be sharp. */
function addLine(c: CanvasRenderingContext2D, [ax, ay]: [number, number],
  [bx, by]: [number, number]): void {
  const sharp = (at: number): number => Math.floor(at) + 0.5;
  if (Math.abs(ax - bx) < 0.01) ax = bx = sharp(ax);
  if (Math.abs(ay - by) < 0.01) ay = by = sharp(ay);
  c.moveTo(ax, ay);
  c.lineTo(bx, by);
}

/** Draws outlines, each with its name beside its uppermost corner. */
export function drawOutlines(c: CanvasRenderingContext2D, camera: Camera, theme: Theme,
  centre: Vector, outlines: Outline[], labels: Labels): void {
  for (const { edges, look, name } of outlines) {
    let topX = Infinity, topY = Infinity;
    const place = (at: number): [number, number] => {
      const [x, y] = camera.project(edges[at]! - centre[0], edges[at + 1]! - centre[1],
        edges[at + 2]! - centre[2]);
      if (y < topY - 0.5 || (y < topY + 0.5 && x < topX)) [topX, topY] = [x, y];
      return [x, y];
    };
    c.beginPath();
    for (let at = 0; at + 5 < edges.length; at += 6) {
      addLine(c, place(at), place(at + 3));
    }
    c.strokeStyle = css(look === 'travel' ? theme.quiet : theme.workpiece);
    c.setLineDash(kDashes[look]);
    c.stroke();
    c.setLineDash([]);
    if (topX < Infinity) labels.write(name, topX, topY, 2);
  }
}
