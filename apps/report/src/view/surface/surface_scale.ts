// SPDX-License-Identifier: MIT
// The scale beside the picture of a surface, and the marks that tell regions apart without colour.

import type { Camera } from '../common/camera.ts';
import { label, niceStep } from '../common/scales.ts';
import { css, type Rgb, type Theme } from '../common/theme.ts';
import { kMet, kMissed, kNoTarget } from './colour_map.ts';
import type { Span } from './surface_image.ts';

export const kFont = '11px system-ui, sans-serif';

/** A scale of colours: `colour` takes 0 for the low end of the span and 1 for the high end. */
export interface Scale {
  title: string;
  span: Span;
  colour: (value: number) => Rgb;
}

/** Draws a bar of colours with its numbers, at the upper right. */
export function drawBar(c: CanvasRenderingContext2D, camera: Camera, theme: Theme,
  { title, span, colour }: Scale): void {
  const x = camera.width - 74, top = 40, width = 14;
  const height = Math.max(60, Math.min(280, camera.height - 110));
  c.fillStyle = css(theme.background, 0.88);
  c.fillRect(x - 10, 0, 84, top + height + 14);
  for (let k = 0; k < height; k++) {
    c.fillStyle = css(colour(1 - k / (height - 1)).map(Math.round) as Rgb);
    c.fillRect(x, top + k, width, 1.5);
  }
  c.font = kFont;
  c.textBaseline = 'middle';
  c.textAlign = 'left';
  c.fillStyle = c.strokeStyle = css(theme.ink);
  c.fillText(title, x, 20);
  drawTicks(c, span, x + width, top, height);
}

function drawTicks(c: CanvasRenderingContext2D, { low, high }: Span, x: number, top: number,
  height: number): void {
  const range = high - low;
  if (!(range > 0)) return;
  const step = niceStep(range / (height / 28));
  c.beginPath();
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) {
    const y = top + height * (1 - (k * step - low) / range);
    c.moveTo(x, Math.round(y) + 0.5);
    c.lineTo(x + 4, Math.round(y) + 0.5);
    c.fillText(label(k * step, step), x + 7, y);
  }
  c.stroke();
}

/** Draws what the colours of targets mean, at the upper right. */
export function drawKey(c: CanvasRenderingContext2D, width: number, theme: Theme): void {
  const x = width - 92;
  c.fillStyle = css(theme.background, 0.88);
  c.fillRect(x - 8, 0, 100, 114);
  c.font = kFont;
  c.textAlign = 'left';
  c.textBaseline = 'middle';
  c.lineWidth = 1;
  const entries: Array<[string, Rgb]> = [['target met', kMet], ['missed', kMissed],
    ['no target', kNoTarget], ['not known', theme.background]];
  entries.forEach(([text, colour], k) => {
    const y = 24 + 22 * k;
    c.fillStyle = css(colour);
    c.fillRect(x, y - 7, 14, 14);
    if (colour === kMissed) hatch(c, x, y - 7, 14);
    c.strokeStyle = css(theme.quiet);
    c.strokeRect(x + 0.5, y - 6.5, 13, 13);
    c.fillStyle = css(theme.ink);
    c.fillText(text, x + 20, y);
  });
}

/** Marks a region by lines from corner to corner, so that it is known without its colour. */
export function hatch(c: CanvasRenderingContext2D, x: number, y: number, size: number): void {
  c.save();
  c.beginPath();
  c.rect(x, y, size, size);
  c.clip();
  c.strokeStyle = 'rgba(0,0,0,0.55)';
  c.lineWidth = 1.2;
  c.beginPath();
  for (let k = -size; k < size; k += Math.max(6, size / 5)) {
    c.moveTo(x + k, y + size);
    c.lineTo(x + k + size, y);
  }
  c.stroke();
  c.restore();
}
