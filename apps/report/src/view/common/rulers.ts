// SPDX-License-Identifier: MIT
// Rulers in mm along the left and the lower edge of a picture that is seen from above.

import type { Camera, Vector } from './camera.ts';
import { label, niceStep } from './scales.ts';
import { css, type Theme } from './theme.ts';

/** Width of the ruler at the left, in CSS pixels. */
export const kRulerLeft = 48;
/** Height of the ruler at the lower edge, in CSS pixels. */
export const kRulerBottom = 22;

/** What rulers show: coordinates of the camera are from `centre`. */
export interface RulerScene {
  centre: Vector;
  theme: Theme;
}

/** Draws the rulers; the context's unit is the CSS pixel. */
export function drawRulers(c: CanvasRenderingContext2D, camera: Camera, scene: RulerScene): void {
  const { centre, theme } = scene;
  const bottom = camera.height - kRulerBottom;
  const step = niceStep(72 / camera.scale);
  drawEdges(c, camera, theme, bottom);
  c.fillStyle = css(theme.quiet);
  c.strokeStyle = css(theme.quiet);
  c.beginPath();
  c.textBaseline = 'middle';
  addTicksOfX(c, camera, centre, step, bottom);
  addTicksOfY(c, camera, centre, step, bottom);
  c.stroke();
  c.fillStyle = css(theme.ink);
  c.fillText('X mm', camera.width - 4, bottom + 13);
  c.fillText('Y mm', kRulerLeft - 8, 11);
}

/** Clears the space of the rulers, and draws the lines along it. */
function drawEdges(c: CanvasRenderingContext2D, camera: Camera, theme: Theme,
  bottom: number): void {
  c.fillStyle = css(theme.background);
  c.fillRect(0, 0, kRulerLeft, camera.height);
  c.fillRect(kRulerLeft, bottom, camera.width - kRulerLeft, kRulerBottom);
  c.strokeStyle = css(theme.grid);
  c.beginPath();
  c.moveTo(kRulerLeft + 0.5, 0);
  c.lineTo(kRulerLeft + 0.5, bottom + 0.5);
  c.lineTo(camera.width, bottom + 0.5);
  c.stroke();
}

function addTicksOfX(c: CanvasRenderingContext2D, camera: Camera, centre: Vector, step: number,
  bottom: number): void {
  const first = camera.target[0] + centre[0] - camera.width / 2 / camera.scale;
  c.textAlign = 'center';
  for (let k = Math.ceil(first / step); ; k++) {
    const x = (k * step - first) * camera.scale;
    if (x > camera.width) break;
    if (x < kRulerLeft) continue;
    c.moveTo(Math.round(x) + 0.5, bottom);
    c.lineTo(Math.round(x) + 0.5, bottom + 5);
    const text = label(k * step, step);
    const half = c.measureText(text).width / 2;
    const hasSpace = x - half > kRulerLeft && x + half < camera.width - 44;
    if (hasSpace) c.fillText(text, x, bottom + 13);
  }
}

function addTicksOfY(c: CanvasRenderingContext2D, camera: Camera, centre: Vector, step: number,
  bottom: number): void {
  const first = camera.target[1] + centre[1] - camera.height / 2 / camera.scale;
  c.textAlign = 'right';
  for (let k = Math.ceil(first / step); ; k++) {
    const y = camera.height - (k * step - first) * camera.scale;
    if (y < 26) break;
    if (y > bottom) continue;
    c.moveTo(kRulerLeft, Math.round(y) + 0.5);
    c.lineTo(kRulerLeft - 5, Math.round(y) + 0.5);
    if (y < bottom - 4) c.fillText(label(k * step, step), kRulerLeft - 8, y);
  }
}
