// SPDX-License-Identifier: MIT
// What draws strips: by WebGL, or by canvas where WebGL is missing.

import type { Camera } from './camera.ts';
import type { Strips } from './strips.ts';
import type { Theme } from './theme.ts';

/** Width of cutting moves in CSS pixels. */
export const kLineWidth = 1.8;
/** Width of rapids in CSS pixels, and their dashes: period and part that is drawn. */
export const kRapidWidth = 1.1;
export const kDash = 9;
export const kDashDrawn = 0.6;
export const kRapidAlpha = 0.75;
/** Width of highlighted stretches in CSS pixels: core, and core with casing. */
export const kHighlightCore = 3.4;
export const kHighlightWidth = 6.4;

/** Slot of strips: the paths, or the highlighted stretches above them. */
export type Slot = 0 | 1;

export interface LineRenderer {
  readonly canvas: HTMLCanvasElement;
  /** Sets the size in CSS pixels and the pixels of the device per CSS pixel. */
  resize(width: number, height: number, ratio: number): void;
  setStrips(slot: Slot, strips: Strips): void;
  /**
   * Draws both slots; `radius` is half of the depth of the scene in mm. Returns how many vertices
   * were drawn.
   */
  draw(camera: Camera, theme: Theme, radius: number): number;
  destroy(): void;
}
