// SPDX-License-Identifier: MIT
// Draws strips on a 2-D canvas, for browsers without WebGL 2.

import type { Camera } from '../common/camera.ts';
import { css, type Theme } from '../common/theme.ts';
import { kBegins, kIsRapid, type Strips } from '../levels/strips.ts';
import * as line from './renderer.ts';

const kNone: Strips = {
  count: 0, position: new Float32Array(0), along: new Float32Array(0), look: new Uint8Array(0),
};

/** Draws strips on a 2-D canvas, in the order of the path. */
export class CanvasLines implements line.LineRenderer {
  readonly canvas: HTMLCanvasElement;
  private readonly slots: [Strips, Strips] = [kNone, kNone];
  private readonly context: CanvasRenderingContext2D;
  private ratio = 1;

  constructor(canvas: HTMLCanvasElement) {
    this.canvas = canvas;
    const context = canvas.getContext('2d', { alpha: false });
    if (context === null) throw new Error('the browser draws neither by WebGL nor on a canvas');
    this.context = context;
  }

  resize(width: number, height: number, ratio: number): void {
    this.ratio = ratio;
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
  }

  setStrips(slot: line.Slot, strips: Strips): void {
    const n = strips.count;
    this.slots[slot] = {
      count: n,
      position: strips.position.slice(0, 3 * n),
      along: strips.along.slice(0, n),
      look: strips.look.slice(0, 4 * n),
    };
  }

  draw(camera: Camera, theme: Theme): number {
    const c = this.context;
    c.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    c.fillStyle = css(theme.background);
    c.fillRect(0, 0, camera.width, camera.height);
    c.lineJoin = 'round';
    c.lineCap = 'butt';
    const places = this.slots.map((strips) => project(strips, camera));
    this.stroke(this.slots[0], places[0]!, (look) => {
      const isRapid = (look[3]! & kIsRapid) !== 0;
      c.lineWidth = isRapid ? line.kRapidWidth : line.kLineWidth;
      c.setLineDash(isRapid ?
        [line.kDash * line.kDashDrawn, line.kDash * (1 - line.kDashDrawn)] : []);
      c.strokeStyle = isRapid ? css(theme.rapid, line.kRapidAlpha) :
        css([look[0]!, look[1]!, look[2]!]);
    });
    for (const [width, colour] of [[line.kHighlightWidth, theme.casing],
      [line.kHighlightCore, theme.highlight]] as const) {
      this.stroke(this.slots[1], places[1]!, () => {
        c.lineWidth = width;
        c.setLineDash([]);
        c.strokeStyle = css(colour);
      });
    }
    return this.slots[0].count + this.slots[1].count;
  }

  destroy(): void {
    this.slots[0] = this.slots[1] = kNone;
  }

  /** Strokes each stretch of one look. */
  private stroke(strips: Strips, places: Float32Array, style: (look: Uint8Array) => void): void {
    const c = this.context, look = strips.look;
    let shown = -1;
    for (let i = 0; i < strips.count; i++) {
      const x = places[2 * i]!, y = places[2 * i + 1]!;
      if ((look[4 * i + 3]! & kBegins) !== 0) {
        if (shown >= 0) c.stroke();
        shown = -1;
        continue;
      }
      if (shown < 0 || !isSameLook(look, shown, i)) {
        if (shown >= 0) c.stroke();
        style(look.subarray(4 * i, 4 * i + 4));
        c.beginPath();
        c.moveTo(places[2 * i - 2]!, places[2 * i - 1]!);
        shown = i;
      }
      c.lineTo(x, y);
    }
    if (shown >= 0) c.stroke();
  }
}

function isSameLook(look: Uint8Array, a: number, b: number): boolean {
  for (let k = 0; k < 4; k++) if (look[4 * a + k] !== look[4 * b + k]) return false;
  return true;
}

/** Returns the places of all nodes on the screen, in CSS pixels. */
function project(strips: Strips, camera: Camera): Float32Array {
  const { right, up } = camera.basis();
  const [tx, ty, tz] = camera.target;
  const places = new Float32Array(2 * strips.count);
  const p = strips.position;
  for (let i = 0; i < strips.count; i++) {
    const x = p[3 * i]! - tx, y = p[3 * i + 1]! - ty, z = p[3 * i + 2]! - tz;
    places[2 * i] = camera.width / 2 + (right[0] * x + right[1] * y + right[2] * z) * camera.scale;
    places[2 * i + 1] = camera.height / 2 - (up[0] * x + up[1] * y + up[2] * z) * camera.scale;
  }
  return places;
}
