// SPDX-License-Identifier: MIT
// What draws strips: by WebGL, or by canvas where WebGL is missing.

import type { Camera } from '../common/camera.ts';
import type { Theme } from '../common/theme.ts';
import type { Strips } from '../levels/strips.ts';

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

/** What a renderer may use to draw faster. */
export interface Scene {
  /** Half of the depth of all paths, in mm. */
  radius: number;
  /** How often the paths, at their full width, cover their part of the screen. */
  coverage: number;
  /** Whether the browser is too slow for smooth lines while the picture moves. */
  isCoarse: boolean;
}

export interface LineRenderer {
  readonly canvas: HTMLCanvasElement;
  /** Sets the size in CSS pixels and the pixels of the device per CSS pixel. */
  resize(width: number, height: number, ratio: number): void;
  setStrips(slot: Slot, strips: Strips): void;
  /** Draws both slots; returns how many vertices were drawn. */
  draw(camera: Camera, theme: Theme, scene: Scene): number;
  destroy(): void;
}
