// SPDX-License-Identifier: MIT
// Box, dimensions, axes, scenery and the tool's marker, drawn on a canvas above the paths.

import type { Box, Camera, Insets, Vector } from '../common/camera.ts';
import { drawRulers, kRulerBottom, kRulerLeft, type RulerScene } from '../common/rulers.ts';
import { label, lengthText, niceStep } from '../common/scales.ts';
import { css, type Theme } from '../common/theme.ts';
import type { Scenery } from '../levels/path_types.ts';
import { drawOrigins, drawTriad } from './axes.ts';
import { kFont, Labels, outlined } from './labels.ts';
import { drawOutlines } from './outlines.ts';

const kNames = ['X', 'Y', 'Z'] as const;

/** Returns the space that rulers and labels need at the edges. */
export function insetsOf(mode: '2d' | '3d'): Insets {
  if (mode === '2d') return { left: kRulerLeft + 14, right: 16, top: 16, bottom: kRulerBottom + 14 };
  return { left: 60, right: 60, top: 30, bottom: 48 };
}

/** What the overlay shows besides the camera. */
export interface OverlayScene extends RulerScene, Scenery {
  /** Box of all paths from `centre`, or null where nothing is drawn. */
  box: Box | null;
  markers: Vector[];
  isDark: boolean;
}

/** Draws the overlay; the context's unit is the CSS pixel. */
export function drawOverlay(c: CanvasRenderingContext2D, camera: Camera,
  scene: OverlayScene): void {
  c.clearRect(0, 0, camera.width, camera.height);
  c.font = kFont;
  c.lineWidth = 1;
  const labels = labelsOf(c, camera, scene);
  drawOutlines(c, camera, scene.theme, scene.centre, scene.outlines, labels);
  drawOrigins(c, camera, scene, scene.centre, scene.origins, labels);
  if (scene.box !== null) {
    if (camera.mode === '2d') {
      drawRulers(c, camera, scene);
    } else {
      drawBox(c, camera, scene, scene.box);
      drawTriad(c, camera, scene);
      drawScaleBar(c, camera, scene.theme);
    }
  }
  for (const marker of scene.markers) drawMarker(c, camera, scene.theme, marker);
}

/** Returns labels that keep clear of the rulers. */
function labelsOf(c: CanvasRenderingContext2D, camera: Camera, { theme }: OverlayScene): Labels {
  const isFlat = camera.mode === '2d';
  return new Labels(c, theme, {
    left: isFlat ? kRulerLeft : 0, top: 0, right: camera.width,
    bottom: camera.height - (isFlat ? kRulerBottom : 0),
  });
}

function corner(box: Box, index: number): Vector {
  return [index & 1 ? box.high[0] : box.low[0], index & 2 ? box.high[1] : box.low[1],
    index & 4 ? box.high[2] : box.low[2]];
}

function drawBox(c: CanvasRenderingContext2D, camera: Camera, scene: OverlayScene,
  box: Box): void {
  const theme = scene.theme;
  const places = Array.from({ length: 8 }, (_, k) => camera.project(...corner(box, k)));
  c.strokeStyle = css(theme.quiet, 0.45);
  c.beginPath();
  for (let k = 0; k < 8; k++) {
    for (const bit of [1, 2, 4]) {
      if (k & bit) continue;
      c.moveTo(...places[k]!);
      c.lineTo(...places[k | bit]!);
    }
  }
  c.stroke();
  const middle = camera.project((box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2,
    (box.low[2] + box.high[2]) / 2);
  for (let axis = 0; axis < 3; axis++) {
    const size = box.high[axis]! - box.low[axis]!;
    if (size * camera.scale < 1 || size < 1e-6) continue;
    drawDimension(c, camera, scene, axis, size, places, middle);
  }
}

/** An edge of the box as it is seen: its middle and its length, in CSS pixels. */
interface Edge {
  middle: [number, number];
  length: number;
}

/**
 * Returns the outermost of the box's four edges along an axis: the leftmost one along z, otherwise
 * the lowest. `places` are the corners and `middle` the middle of the box as they are seen.
 */
function outermostEdge(axis: number, places: Array<[number, number]>,
  middle: [number, number]): Edge | null {
  const bit = 1 << axis;
  let best: Edge | null = null, bestScore = -Infinity;
  for (let k = 0; k < 8; k++) {
    if (k & bit) continue;
    const [ax, ay] = places[k]!, [bx, by] = places[k | bit]!;
    const x = (ax + bx) / 2, y = (ay + by) / 2;
    const score = axis === 2 ? middle[0] - x : y - middle[1];
    if (score <= bestScore) continue;
    bestScore = score;
    best = { middle: [x, y], length: Math.hypot(bx - ax, by - ay) };
  }
  return best;
}

/** Writes the dimension of one axis beside the box. */
function drawDimension(c: CanvasRenderingContext2D, camera: Camera, scene: OverlayScene,
  axis: number, size: number, places: Array<[number, number]>, middle: [number, number]): void {
  const edge = outermostEdge(axis, places, middle);
  if (edge === null || edge.length < 14 || !isInside(camera, edge.middle)) return;
  const [ex, ey] = edge.middle;
  let dx = ex - middle[0], dy = ey - middle[1];
  if (Math.hypot(dx, dy) < 2) [dx, dy] = axis === 2 ? [-1, 0] : [0, 1]; // a box without width
  const n = Math.hypot(dx, dy);
  const text = `${kNames[axis]!} ${lengthText(size)} mm`;
  c.font = kFont;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  const half = c.measureText(text).width / 2;
  const away = 8 + Math.abs(dx / n) * half + Math.abs(dy / n) * 7;
  const x = Math.min(camera.width - half - 4, Math.max(half + 4, ex + dx / n * away));
  const y = Math.min(camera.height - 10, Math.max(10, ey + dy / n * away));
  c.fillStyle = css(scene.theme.background, 0.8);
  c.fillRect(x - half - 3, y - 8, 2 * half + 6, 16);
  c.fillStyle = css(scene.theme.ink);
  c.fillText(text, x, y);
}

function isInside(camera: Camera, [x, y]: [number, number]): boolean {
  return x > 0 && y > 0 && x < camera.width && y < camera.height;
}

function drawScaleBar(c: CanvasRenderingContext2D, camera: Camera, theme: Theme): void {
  const most = 110 / camera.scale;
  const step = niceStep(most / 2.5 * (1 + 1e-9));
  const length = step * camera.scale;
  const x = camera.width - 16 - length, y = camera.height - 14;
  c.strokeStyle = css(theme.ink);
  c.lineWidth = 1.5;
  c.beginPath();
  c.moveTo(x, y - 4); c.lineTo(x, y); c.lineTo(x + length, y); c.lineTo(x + length, y - 4);
  c.stroke();
  c.lineWidth = 1;
  c.font = kFont;
  c.textAlign = 'center';
  c.textBaseline = 'bottom';
  c.fillStyle = css(theme.ink);
  outlined(c, `${label(step, step)} mm`, x + length / 2, y - 5, theme);
}

function drawMarker(c: CanvasRenderingContext2D, camera: Camera, theme: Theme,
  place: Vector): void {
  const [x, y] = camera.project(...place);
  c.beginPath();
  c.arc(x, y, 6, 0, 2 * Math.PI);
  c.strokeStyle = css(theme.casing);
  c.lineWidth = 4;
  c.stroke();
  c.strokeStyle = css(theme.highlight);
  c.lineWidth = 2;
  c.stroke();
  c.beginPath();
  c.arc(x, y, 1.6, 0, 2 * Math.PI);
  c.fillStyle = css(theme.casing);
  c.fill();
  c.lineWidth = 1;
}
