// SPDX-License-Identifier: MIT
// Axes as they are seen: a triad in a corner, and a small cross at the origin of each work system.

import type { Camera, Vector } from '../common/camera.ts';
import { css, type Rgb, type Theme } from '../common/theme.ts';
import type { Origin } from '../levels/path_types.ts';
import { kBold, type Labels, outlined } from './labels.ts';

const kNames = ['X', 'Y', 'Z'] as const;
// Colours of the axes that everyone can distinguish (Okabe and Ito, 2008): vermilion, green, blue.
const kLight: [Rgb, Rgb, Rgb] = [[213, 94, 0], [0, 158, 115], [0, 114, 178]];
const kDark: [Rgb, Rgb, Rgb] = [[240, 130, 50], [40, 190, 145], [86, 180, 233]];
const kTriad = { behind: 0, ahead: 24 }; // CSS px.
const kCross = { behind: 7, ahead: 18 };

/** How the axes are drawn. */
export interface AxesLook {
  theme: Theme;
  isDark: boolean;
}

/** Draws the directions of the axes at the lower left corner. */
export function drawTriad(c: CanvasRenderingContext2D, camera: Camera, look: AxesLook): void {
  const x0 = 40, y0 = camera.height - 40;
  c.font = kBold;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  drawAxes(c, camera, x0, y0, kTriad, look, (axis, x, y) => {
    const n = Math.hypot(x, y);
    if (n > 5) outlined(c, kNames[axis]!, x0 + x + x / n * 8, y0 + y + y / n * 8, look.theme);
  });
}

/** Draws a cross at each origin, with the name of its systems. */
export function drawOrigins(c: CanvasRenderingContext2D, camera: Camera, look: AxesLook,
  centre: Vector, origins: Origin[], labels: Labels): void {
  const places = origins.map(({ at }) =>
    camera.project(at[0] - centre[0], at[1] - centre[1], at[2] - centre[2]));
  for (const [x, y] of places) drawAxes(c, camera, x, y, kCross, look);
  origins.forEach(({ name }, k) => labels.write(name, ...places[k]!, 6));
}

/** Draws the axes through a place of the screen; `named` gets each with the end of its line. */
function drawAxes(c: CanvasRenderingContext2D, camera: Camera, x0: number, y0: number,
  { behind, ahead }: typeof kTriad, { theme, isDark }: AxesLook,
  named?: (axis: number, x: number, y: number) => void): void {
  const { right, up, towards } = camera.basis();
  const colours = isDark ? kDark : kLight;
  const order = [0, 1, 2].sort((a, b) => towards[a]! - towards[b]!);
  for (const axis of order) {
    const x = right[axis]!, y = -up[axis]!;
    c.beginPath();
    c.moveTo(x0 - x * behind, y0 - y * behind);
    c.lineTo(x0 + x * ahead, y0 + y * ahead);
    c.strokeStyle = css(theme.background, 0.9);
    c.lineWidth = 5;
    c.stroke();
    c.strokeStyle = c.fillStyle = css(colours[axis]!);
    c.lineWidth = 2;
    c.stroke();
    named?.(axis, x * ahead, y * ahead);
  }
  c.lineWidth = 1;
}
