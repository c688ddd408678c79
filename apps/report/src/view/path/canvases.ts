// SPDX-License-Identifier: MIT
// The two canvases of a picture of paths: the lines, and the overlay above them.

import type { Camera } from '../common/camera.ts';
import { CanvasLines } from '../lines/canvas_lines.ts';
import type { LineRenderer } from '../lines/renderer.ts';
import { WebGlLines } from '../lines/webgl_lines.ts';

/** Returns the pixels of the device per CSS pixel, from 1 to 3. */
export function deviceRatio(): number {
  return Math.min(3, Math.max(1, window.devicePixelRatio || 1));
}

/** The canvases; the lines are drawn by WebGL, or by canvas where the browser does not have it. */
export class Canvases {
  /** What draws the lines at the moment. */
  renderer: LineRenderer;
  private readonly root: HTMLElement;
  private readonly camera: Camera;
  private readonly replaced: () => void;
  private readonly overlay = document.createElement('canvas');
  private part = 1; // Of the screen's resolution at which the lines are drawn.

  /**
   * Puts the canvases into `root`. They have the size of the camera. Calls `replaced` when the
   * renderer is another one, which has no size and no strips.
   */
  constructor(root: HTMLElement, camera: Camera, replaced: () => void) {
    this.root = root;
    this.camera = camera;
    this.replaced = replaced;
    this.renderer = this.createRenderer();
    this.overlay.style.cssText =
      'position:absolute;left:0;top:0;width:100%;height:100%;pointer-events:none;';
    root.append(this.overlay);
  }

  /** Gives the canvases their pixels, `ratio` for each CSS pixel; both need to be drawn then. */
  setSize(ratio: number): void {
    const { width, height } = this.camera;
    this.part = 1;
    this.renderer.resize(width, height, ratio);
    this.overlay.width = Math.round(width * ratio);
    this.overlay.height = Math.round(height * ratio);
  }

  /** Sets the part of the screen's resolution at which the lines are drawn. */
  setPart(part: number): void {
    if (part === this.part) return;
    this.part = part;
    this.renderer.resize(this.camera.width, this.camera.height, deviceRatio() * part);
  }

  /** Returns what draws the overlay; its unit is the CSS pixel. */
  overlayContext(): CanvasRenderingContext2D | null {
    const context = this.overlay.getContext('2d');
    const ratio = this.overlay.width / this.camera.width;
    context?.setTransform(ratio, 0, 0, ratio, 0, 0);
    return context;
  }

  /** Returns both canvases in one, as they are drawn, as a data URL (PNG). */
  image(): string {
    const canvas = document.createElement('canvas');
    canvas.width = this.renderer.canvas.width;
    canvas.height = this.renderer.canvas.height;
    const context = canvas.getContext('2d');
    context?.drawImage(this.renderer.canvas, 0, 0);
    context?.drawImage(this.overlay, 0, 0, canvas.width, canvas.height);
    return context === null ? '' : canvas.toDataURL('image/png');
  }

  private createRenderer(): LineRenderer {
    const canvas = newCanvas();
    let renderer: LineRenderer | null = WebGlLines.create(canvas);
    if (renderer === null) renderer = new CanvasLines(newCanvas());
    renderer.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.replace(renderer);
    });
    this.root.prepend(renderer.canvas);
    return renderer;
  }

  /** Draws on without WebGL where the browser has taken its context away. */
  private replace(lost: LineRenderer | null): void {
    if (lost !== this.renderer || !this.root.isConnected) return;
    lost.canvas.remove();
    this.renderer = new CanvasLines(newCanvas());
    this.root.prepend(this.renderer.canvas);
    this.replaced();
  }
}

function newCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;left:0;top:0;width:100%;height:100%;';
  return canvas;
}
