// SPDX-License-Identifier: MIT
// The picture of one or two paths: camera, levels of detail, renderer, overlay and gestures.

import { Camera, type Box, type Vector } from '../common/camera.ts';
import { CanvasLines } from '../lines/canvas_lines.ts';
import { FrameNodes } from './frame_nodes.ts';
import { connectGestures } from '../common/gestures.ts';
import { PathLevels } from '../levels/levels.ts';
import { MotionQuality } from './motion_quality.ts';
import { drawOverlay, insetsOf } from '../common/overlay.ts';
import type {
  FrameFigures, HitListener, PathLayer, PathRange, PathView,
} from '../levels/path_types.ts';
import { pick, positionAtRow } from '../levels/picking.ts';
import type { LineRenderer } from '../lines/renderer.ts';
import { themeOf } from '../common/theme.ts';
import { WebGlLines } from '../lines/webgl_lines.ts';

export type {
  FrameFigures, HitListener, PathHit, PathLayer, PathRange, PathView,
} from '../levels/path_types.ts';

const kPrintRatio = 2; // Pixels per CSS pixel of the image for printing.
const kContinuousMs = 250; // Frames further apart than this do not follow one another.

/** Creates a picture that fills the container and follows its size. */
export function createPathView(container: HTMLElement): PathView {
  return new View(container);
}

/** The element of a picture; browser tests ask it where a row of a run is drawn. */
interface PathElement extends HTMLDivElement {
  /** Returns the place in CSS pixels from the element's corner, or null. */
  placeOf?: (layer: number, row: number) => [number, number] | null;
}

class View implements PathView {
  private readonly container: HTMLElement;
  private readonly root: PathElement = document.createElement('div');
  private readonly overlay = document.createElement('canvas');
  private renderer: LineRenderer;
  private readonly camera = new Camera();
  private readonly nodes = new FrameNodes();
  private readonly quality = new MotionQuality();
  private readonly observer: ResizeObserver;
  private readonly disconnect: () => void;
  private paths: PathLevels[] = [];
  private centre: Vector = [0, 0, 0];
  private box: Box | null = null;
  private markers: Array<number | null> = [];
  private theme = themeOf(false, document.documentElement);
  private isDark = false;
  private pickListener: HitListener | null = null;
  private hoverListener: HitListener | null = null;
  private hoverWaiting: (() => void) | null = null;
  private frame = 0;
  private lastFrameAt = -Infinity;
  private wantsFit = true;
  private wantsPaths = true;
  private ratioPart = 1;
  private figures: FrameFigures = { vertices: 0, level: 0, lastFrameMs: 0 };

  constructor(container: HTMLElement) {
    this.container = container;
    const root = this.root;
    root.style.cssText = 'position:absolute;inset:0;overflow:hidden;';
    root.tabIndex = 0;
    root.setAttribute('role', 'application');
    if (getComputedStyle(container).position === 'static') container.style.position = 'relative';
    this.renderer = this.createRenderer();
    this.overlay.style.cssText =
      'position:absolute;left:0;top:0;width:100%;height:100%;pointer-events:none;';
    root.append(this.overlay);
    container.append(root);
    this.describe();
    this.theme = themeOf(false, container);
    this.disconnect = connectGestures(root, {
      drag: (dx, dy) => {
        if (this.camera.mode === '3d') this.camera.rotate(dx, dy);
        else this.camera.pan(dx, dy);
        this.moved();
      },
      pan: (dx, dy) => {
        this.camera.pan(dx, dy);
        this.moved();
      },
      zoom: (factor, x, y) => {
        this.camera.zoomAt(factor, x, y);
        this.moved();
      },
      fit: () => this.fit(),
      click: (x, y, event) => this.pickListener?.(pick(this.paths, this.camera, x, y), event),
      hover: (place, event) => this.hover(place, event),
    });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(root);
    root.placeOf = (layer, row) => this.placeOf(layer, row);
    this.resize();
  }

  setLayers(layers: PathLayer[]): void {
    this.centre = centreOf(layers);
    this.paths = layers.map((layer) => new PathLevels(layer, this.centre));
    this.paths.forEach((path) => path.setFlat(this.camera.mode === '2d'));
    this.nodes.setPaths(this.paths);
    this.markers = layers.map(() => null);
    this.findDrawn();
    this.fit();
  }

  setColours(layer: number, rgb: Uint8Array): void {
    this.paths[layer]?.setColours(rgb);
    this.forget();
  }

  setVisible(layer: number, visible: Uint8Array | null): void {
    const path = this.paths[layer];
    if (path === undefined || (visible === null && path.visible === null)) return;
    path.setVisible(visible);
    this.findDrawn();
  }

  highlight(ranges: PathRange[]): void {
    this.nodes.setRanges(ranges);
    this.draw();
  }

  setMarker(layer: number, row: number | null): void {
    this.markers[layer] = row;
    this.schedule();
  }

  fit(): void {
    if (this.root.clientWidth < 2) {
      this.wantsFit = true;
      return;
    }
    this.wantsFit = false;
    if (this.box !== null) this.camera.fit(this.box, insetsOf(this.camera.mode));
    this.draw();
  }

  setMode(mode: '2d' | '3d'): void {
    this.camera.mode = mode;
    this.paths.forEach((path) => path.setFlat(mode === '2d'));
    this.describe();
    this.nodes.forget();
    this.fit();
  }

  setTheme(dark: boolean): void {
    this.isDark = dark;
    this.theme = themeOf(dark, this.container);
    this.draw();
  }

  onPick(callback: HitListener): void {
    this.pickListener = callback;
  }

  onHover(callback: HitListener): void {
    this.hoverListener = callback;
  }

  toImage(): string {
    this.setSize(Math.max(kPrintRatio, deviceRatio()));
    this.render();
    const canvas = document.createElement('canvas');
    canvas.width = this.renderer.canvas.width;
    canvas.height = this.renderer.canvas.height;
    const context = canvas.getContext('2d');
    context?.drawImage(this.renderer.canvas, 0, 0);
    context?.drawImage(this.overlay, 0, 0, canvas.width, canvas.height);
    this.setSize(deviceRatio());
    this.draw();
    return context === null ? '' : canvas.toDataURL('image/png');
  }

  frames(): FrameFigures {
    return { ...this.figures };
  }

  destroy(): void {
    cancelAnimationFrame(this.frame);
    this.quality.stop();
    this.observer.disconnect();
    this.disconnect();
    this.renderer.destroy();
    this.root.remove();
    this.paths = [];
  }

  private placeOf(layer: number, row: number): [number, number] | null {
    const path = this.paths[layer];
    if (path === undefined || path.count === 0) return null;
    return this.camera.project(...positionAtRow(path, row));
  }

  private describe(): void {
    const arrows = this.camera.mode === '3d' ? 'turn the path, with Shift move it' : 'move the path';
    this.root.setAttribute('aria-label',
      `Path of the tool. Arrow keys ${arrows}; plus and minus zoom; 0 fits it to the picture.`);
  }

  private createRenderer(): LineRenderer {
    const canvas = newCanvas();
    let renderer: LineRenderer | null = WebGlLines.create(canvas);
    if (renderer === null) renderer = new CanvasLines(newCanvas());
    renderer.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.replaceRenderer(renderer);
    });
    this.root.prepend(renderer.canvas);
    return renderer;
  }

  /** Draws on without WebGL where the browser has taken its context away. */
  private replaceRenderer(lost: LineRenderer | null): void {
    if (lost !== this.renderer || !this.root.isConnected) return;
    lost.canvas.remove();
    this.renderer = new CanvasLines(newCanvas());
    this.root.prepend(this.renderer.canvas);
    this.forget();
    this.resize();
  }

  private hover(place: [number, number] | null, event: PointerEvent): void {
    if (this.hoverListener === null) return;
    const isWaiting = this.hoverWaiting !== null;
    this.hoverWaiting = () => {
      const hit = place === null ? null : pick(this.paths, this.camera, ...place);
      this.root.style.cursor = hit === null ? 'default' : 'pointer';
      this.hoverListener?.(hit, event);
    };
    if (isWaiting) return;
    requestAnimationFrame(() => {
      const call = this.hoverWaiting;
      this.hoverWaiting = null;
      call?.();
    });
  }

  private resize(): void {
    const width = this.root.clientWidth, height = this.root.clientHeight;
    if (width < 2 || height < 2) return;
    const keepsScale = this.camera.width > 1 && !this.wantsFit;
    const grown = Math.min(width / this.camera.width, height / this.camera.height);
    this.camera.width = width;
    this.camera.height = height;
    if (keepsScale) this.camera.scale *= grown;
    this.setSize(deviceRatio());
    if (this.wantsFit) this.fit();
    this.render();
  }

  /** Gives the canvases their pixels, `ratio` for each CSS pixel. */
  private setSize(ratio: number): void {
    const { width, height } = this.camera;
    this.ratioPart = 1;
    this.renderer.resize(width, height, ratio);
    this.overlay.width = Math.round(width * ratio);
    this.overlay.height = Math.round(height * ratio);
    this.wantsPaths = true;
  }

  /** Draws while the picture moves, coarser where the browser is slow. */
  private moved(): void {
    this.quality.move(() => {
      this.setRatio(1);
      this.draw();
    });
    this.draw();
  }

  /** Sets the part of the screen's resolution at which the paths are drawn. */
  private setRatio(part: number): void {
    if (part === this.ratioPart) return;
    this.ratioPart = part;
    this.renderer.resize(this.camera.width, this.camera.height, deviceRatio() * part);
  }

  /** Makes the next frame choose its nodes again. */
  private forget(): void {
    this.nodes.forget();
    this.draw();
  }

  private findDrawn(): void {
    this.box = this.paths.map((path) => path.drawnBox()).reduce(join, null);
    this.forget();
  }

  /** Draws paths and overlay in the next frame. */
  private draw(): void {
    this.wantsPaths = true;
    this.schedule();
  }

  /** Draws what has changed in the next frame; the overlay always. */
  private schedule(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.render();
    });
  }

  private render(): void {
    if (this.camera.width < 2) return;
    if (this.wantsPaths) this.renderPaths();
    this.wantsPaths = false;
    this.renderOverlay();
  }

  private renderPaths(): void {
    const start = performance.now();
    const sinceLast = start - this.lastFrameAt;
    const follows = sinceLast < kContinuousMs;
    if (follows) this.quality.note(sinceLast);
    const { part } = this.quality;
    this.setRatio(part < 1 ? 1 / deviceRatio() : 1);
    const changes = this.nodes.choose(this.camera, this.box, part);
    if (changes.strips) this.renderer.setStrips(0, this.nodes.strips.strips);
    if (changes.lit) this.renderer.setStrips(1, this.nodes.lit.strips);
    const vertices = this.renderer.draw(this.camera, this.theme, {
      radius: Math.hypot(...this.centredRadius()), coverage: this.nodes.coverage, isCoarse: part < 1,
    });
    this.figures = {
      vertices,
      level: this.nodes.level(this.camera),
      lastFrameMs: follows ? sinceLast : performance.now() - start,
    };
    this.lastFrameAt = start;
  }

  /** Returns the largest distance from the centre along each axis, in mm. */
  private centredRadius(): Vector {
    const { low, high } = this.box ?? { low: [0, 0, 0], high: [0, 0, 0] };
    return [0, 1, 2].map((k) => Math.max(-low[k]!, high[k]!)) as Vector;
  }

  private renderOverlay(): void {
    const context = this.overlay.getContext('2d');
    if (context === null) return;
    const ratio = this.overlay.width / this.camera.width;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const markers: Vector[] = [];
    this.markers.forEach((row, k) => {
      const path = this.paths[k];
      if (row !== null && path !== undefined && path.count > 0) {
        markers.push(positionAtRow(path, row));
      }
    });
    drawOverlay(context, this.camera, {
      box: this.box, centre: this.centre, markers, isDark: this.isDark, theme: this.theme,
    });
  }
}

function deviceRatio(): number {
  return Math.min(3, Math.max(1, window.devicePixelRatio || 1));
}

function newCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;left:0;top:0;width:100%;height:100%;';
  return canvas;
}

function join(a: Box | null, b: Box | null): Box | null {
  if (a === null || b === null) return a ?? b;
  const pick = (f: (a: number, b: number) => number, u: Vector, v: Vector): Vector =>
    [f(u[0], v[0]), f(u[1], v[1]), f(u[2], v[2])];
  return { low: pick(Math.min, a.low, b.low), high: pick(Math.max, a.high, b.high) };
}

/** Returns the middle of the box of all nodes, in mm. */
function centreOf(layers: PathLayer[]): Vector {
  const middle = (axis: 'x' | 'y' | 'z'): number => {
    let low = Infinity, high = -Infinity;
    for (const layer of layers) {
      for (const value of layer[axis]) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return low <= high ? (low + high) / 2 : 0;
  };
  return [middle('x'), middle('y'), middle('z')];
}
