// SPDX-License-Identifier: MIT
// The picture of a surface: heights, roughness, or targets that are met and missed.

import type { DecodedSurface } from '../../data/surface.ts';
import { Camera, type Box, type Insets, type Vector } from '../common/camera.ts';
import { connectGestures } from '../common/gestures.ts';
import { drawRulers } from '../common/rulers.ts';
import { css, themeOf, type Theme } from '../common/theme.ts';
import { heightColour, roughnessColour } from './colour_map.ts';
import {
  heightImage, roughnessImage, spanOf, verdict, verdictImage, type Span,
} from './surface_image.ts';
import { micrometres, readout } from './surface_readout.ts';
import { drawBar, drawKey, hatch, kFont, type Scale } from './surface_scale.ts';

export type SurfaceLook = 'height' | 'rmax' | 'met';

/** An interactive picture of a surface, seen from above. */
export interface SurfaceView {
  show(what: SurfaceLook): void;
  setTheme(dark: boolean): void;
  /** Shows the whole surface. */
  fit(): void;
  /** Removes the picture and all its listeners. */
  destroy(): void;
}

const kInsets: Insets = { left: 62, right: 96, top: 34, bottom: 40 };
const kNumbersFrom = 44; // CSS px: regions at least this large carry their numbers.
const kHatchFrom = 7; // CSS px: smaller regions are too small to be hatched.

/** Creates a picture that fills the container and follows its size. */
export function createSurfaceView(container: HTMLElement, surface: DecodedSurface): SurfaceView {
  return new View(container, surface);
}

/** The canvas of a picture; browser tests ask it where a place of the surface is drawn. */
interface SurfaceCanvas extends HTMLCanvasElement {
  /** Returns the place of x, y in mm in CSS pixels from the canvas' corner. */
  placeOf?: (x: number, y: number) => [number, number];
}

class View implements SurfaceView {
  private readonly container: HTMLElement;
  private readonly surface: DecodedSurface;
  private readonly canvas: SurfaceCanvas = document.createElement('canvas');
  private readonly camera = new Camera();
  private readonly observer: ResizeObserver;
  private readonly disconnect: () => void;
  private readonly heights: Span;
  private readonly roughness: Span;
  private readonly centre: Vector;
  private readonly box: Box;
  private readonly images = new Map<SurfaceLook, HTMLCanvasElement>();
  private theme: Theme;
  private look: SurfaceLook = 'height';
  private pointer: [number, number] | null = null;
  private frame = 0;
  private wantsFit = true;

  constructor(container: HTMLElement, surface: DecodedSurface) {
    this.container = container;
    this.surface = surface;
    this.theme = themeOf(false, container);
    this.heights = spanOf(surface.heights);
    this.roughness = { low: 0, high: spanOf(surface.rmax, 0).high };
    const width = Math.max((surface.columns - 1) * surface.spacing,
      surface.regionColumns * surface.regionSize);
    const height = Math.max((surface.rows - 1) * surface.spacing,
      surface.regionRows * surface.regionSize);
    this.centre = [surface.origin[0] + width / 2, surface.origin[1] + height / 2, 0];
    this.box = { low: [-width / 2, -height / 2, 0], high: [width / 2, height / 2, 0] };
    if (getComputedStyle(container).position === 'static') container.style.position = 'relative';
    this.canvas.style.cssText = 'position:absolute;left:0;top:0;width:100%;height:100%;';
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'application');
    container.append(this.canvas);
    this.describe();
    this.disconnect = connectGestures(this.canvas, {
      drag: (dx, dy) => this.pan(dx, dy),
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor, x, y) => {
        this.camera.zoomAt(factor, x, y);
        this.draw();
      },
      fit: () => this.fit(),
      click: (x, y) => this.point([x, y]),
      hover: (place) => this.point(place),
    });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.canvas);
    this.canvas.placeOf = (x, y) =>
      this.camera.project(x - this.centre[0], y - this.centre[1], 0);
    this.resize();
  }

  show(what: SurfaceLook): void {
    this.look = what;
    this.describe();
    this.draw();
  }

  setTheme(dark: boolean): void {
    this.theme = themeOf(dark, this.container);
    this.draw();
  }

  fit(): void {
    this.wantsFit = this.canvas.clientWidth < 2;
    if (this.wantsFit) return;
    this.camera.fit(this.box, kInsets);
    this.draw();
  }

  destroy(): void {
    cancelAnimationFrame(this.frame);
    this.observer.disconnect();
    this.disconnect();
    this.canvas.remove();
  }

  private describe(): void {
    const what = { height: 'Heights', rmax: 'Roughness Rmax', met: 'Targets of roughness' }[this.look];
    this.canvas.setAttribute('aria-label', `${what} of the surface, seen from above. ` +
      'Arrow keys move it; plus and minus zoom; 0 fits it to the picture.');
  }

  private pan(dx: number, dy: number): void {
    this.camera.pan(dx, dy);
    this.draw();
  }

  private point(place: [number, number] | null): void {
    this.pointer = place;
    this.draw();
  }

  private resize(): void {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (width < 2 || height < 2) return;
    const ratio = Math.min(3, Math.max(1, window.devicePixelRatio || 1));
    if (!this.wantsFit) {
      this.camera.scale *= Math.min(width / this.camera.width, height / this.camera.height);
    }
    this.camera.width = width;
    this.camera.height = height;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    if (this.wantsFit) this.fit();
    this.render();
  }

  private draw(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.render();
    });
  }

  private render(): void {
    const c = this.canvas.getContext('2d', { alpha: false });
    if (c === null || this.camera.width < 2) return;
    const ratio = this.canvas.width / this.camera.width;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.fillStyle = css(this.theme.background);
    c.fillRect(0, 0, this.camera.width, this.camera.height);
    this.drawImage(c);
    if (this.look !== 'height') this.drawRegions(c);
    c.font = kFont;
    drawRulers(c, this.camera, { centre: this.centre, theme: this.theme });
    if (this.look === 'met') drawKey(c, this.camera.width, this.theme);
    else drawBar(c, this.camera, this.theme, this.scale());
    this.drawReadout(c);
  }

  private image(): HTMLCanvasElement {
    let image = this.images.get(this.look);
    if (image === undefined) {
      image = this.look === 'height' ? heightImage(this.surface, this.heights) :
        this.look === 'rmax' ? roughnessImage(this.surface, this.roughness) :
        verdictImage(this.surface);
      this.images.set(this.look, image);
    }
    return image;
  }

  /** Draws the picture at its place; heights lie in the middles of its pixels. */
  private drawImage(c: CanvasRenderingContext2D): void {
    const s = this.surface;
    const isHeight = this.look === 'height';
    const cell = isHeight ? s.spacing : s.regionSize;
    const columns = isHeight ? s.columns : s.regionColumns;
    const rows = isHeight ? s.rows : s.regionRows;
    const shift = isHeight ? -cell / 2 : 0;
    const left = this.box.low[0] + shift, low = this.box.low[1] + shift;
    const [x, y] = this.camera.project(left, low + rows * cell, 0);
    c.imageSmoothingEnabled = isHeight;
    c.imageSmoothingQuality = 'high';
    c.drawImage(this.image(), x, y, columns * cell * this.camera.scale,
      rows * cell * this.camera.scale);
  }

  /** Draws edges, hatching of misses and numbers of the regions, as far as they have space. */
  private drawRegions(c: CanvasRenderingContext2D): void {
    const s = this.surface, size = s.regionSize * this.camera.scale;
    if (size < kHatchFrom) return;
    c.font = kFont;
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    for (let region = 0; region < s.rmax.length; region++) {
      const column = region % s.regionColumns, row = Math.floor(region / s.regionColumns);
      const [x, y] = this.camera.project(this.box.low[0] + column * s.regionSize,
        this.box.low[1] + (row + 1) * s.regionSize, 0);
      if (x > this.camera.width || y > this.camera.height || x + size < 0 || y + size < 0) continue;
      if (!(s.rmax[region]! >= 0)) continue;
      if (verdict(s, region) === 'missed') hatch(c, x, y, size);
      c.strokeStyle = css(this.theme.background, 0.35);
      c.lineWidth = 1;
      c.strokeRect(Math.round(x) + 0.5, Math.round(y) + 0.5, size, size);
      if (size >= kNumbersFrom) this.drawNumbers(c, region, x + size / 2, y + size / 2);
    }
  }

  private drawNumbers(c: CanvasRenderingContext2D, region: number, x: number, y: number): void {
    const target = this.surface.target[region]!;
    const lines = [micrometres(this.surface.rmax[region]!)];
    if (target > 0) lines.push(`of ${micrometres(target)}`);
    const width = Math.max(...lines.map((line) => c.measureText(line).width));
    c.fillStyle = css(this.theme.background, 0.85);
    c.fillRect(x - width / 2 - 3, y - 7 * lines.length - 1, width + 6, 14 * lines.length + 2);
    c.fillStyle = css(this.theme.ink);
    lines.forEach((line, k) => c.fillText(line, x, y + 14 * (k - (lines.length - 1) / 2)));
  }

  private scale(): Scale {
    const z = this.surface.origin[2];
    if (this.look === 'rmax') {
      return { title: 'Rmax, \u00b5m', span: this.roughness, colour: roughnessColour };
    }
    const span = { low: this.heights.low + z, high: this.heights.high + z };
    return { title: 'height, mm', span, colour: heightColour };
  }

  /** Writes what is under the pointer, in the upper left corner. */
  private drawReadout(c: CanvasRenderingContext2D): void {
    const text = this.pointer === null ? null : this.numbersAt(...this.pointer);
    if (text === null) return;
    c.font = kFont;
    c.textAlign = 'left';
    c.textBaseline = 'middle';
    const width = c.measureText(text).width;
    c.fillStyle = css(this.theme.background, 0.92);
    c.fillRect(56, 6, width + 12, 20);
    c.fillStyle = css(this.theme.ink);
    c.fillText(text, 62, 16);
  }

  private numbersAt(px: number, py: number): string | null {
    const { width, height, scale, target } = this.camera;
    const x = (px - width / 2) / scale + target[0] - this.box.low[0];
    const y = (height / 2 - py) / scale + target[1] - this.box.low[1];
    return readout(this.surface, x, y);
  }
}
