// SPDX-License-Identifier: MIT
// The picture of one or two paths: camera, levels of detail, renderer, overlay and gestures.

import { Camera, type Box, type Vector } from './camera';
import { CanvasLines } from './canvas_lines';
import { connectGestures } from './gestures';
import { PathLevels } from './levels';
import { drawOverlay, insetsOf } from './overlay';
import type {
  FrameFigures, HitListener, PathLayer, PathRange, PathView,
} from './path_types';
import { nodeAtRow, pick, positionAtRow } from './picking';
import type { LineRenderer } from './renderer';
import {
  addChunks, addNodes, chooseCode, finestCode, kMostNodes, markChunks, StripBuilder,
} from './strips';
import { themeOf } from './theme';
import { WebGlLines } from './webgl_lines';

export type {
  FrameFigures, HitListener, PathHit, PathLayer, PathRange, PathView,
} from './path_types';

const kHighlightNodes = kMostNodes / 4;
const kContinuousMs = 250; // Frames further apart than this do not follow one another.

/** Creates a picture that fills the container and follows its size. */
export function createPathView(container: HTMLElement): PathView {
  return new View(container);
}

class View implements PathView {
  private readonly root = document.createElement('div');
  private readonly overlay = document.createElement('canvas');
  private renderer: LineRenderer;
  private readonly camera = new Camera();
  private readonly strips = new StripBuilder(kMostNodes);
  private readonly lit = new StripBuilder(kHighlightNodes);
  private readonly observer: ResizeObserver;
  private readonly disconnect: () => void;
  private paths: PathLevels[] = [];
  private marks: Uint8Array[] = [];
  private drawnChunks: Uint8Array[] = [];
  private centre: Vector = [0, 0, 0];
  private box: Box | null = null;
  private ranges: PathRange[] = [];
  private markers: Array<number | null> = [];
  private theme = themeOf(false, document.documentElement);
  private isDark = false;
  private pickListener: HitListener | null = null;
  private hoverListener: HitListener | null = null;
  private hoverWaiting: (() => void) | null = null;
  private shownMarks: Uint8Array[] = [];
  private shownCode = -1;
  private litCode = -1;
  private frame = 0;
  private lastFrameAt = -Infinity;
  private wantsFit = true;
  private figures: FrameFigures = { vertices: 0, level: 0, lastFrameMs: 0 };

  constructor(private readonly container: HTMLElement) {
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
    this.resize();
  }

  setLayers(layers: PathLayer[]): void {
    this.box = boxOf(layers);
    this.centre = [0, 0, 0];
    if (this.box !== null) {
      const { low, high } = this.box;
      for (let k = 0; k < 3; k++) {
        this.centre[k] = (low[k]! + high[k]!) / 2;
        low[k]! -= this.centre[k]!;
        high[k]! -= this.centre[k]!;
      }
    }
    this.paths = layers.map((layer) => new PathLevels(layer, this.centre));
    this.marks = this.paths.map((path) => new Uint8Array(path.chunks));
    this.ranges = [];
    this.markers = layers.map(() => null);
    this.findDrawn();
    this.fit();
  }

  setColours(layer: number, rgb: Uint8Array): void {
    this.paths[layer]?.setColours(rgb);
    this.forget();
  }

  setVisible(layer: number, visible: Uint8Array | null): void {
    this.paths[layer]?.setVisible(visible);
    this.findDrawn();
  }

  highlight(ranges: PathRange[]): void {
    this.ranges = ranges.slice();
    this.litCode = -1;
    this.draw();
  }

  setMarker(layer: number, row: number | null): void {
    this.markers[layer] = row;
    this.draw();
  }

  fit(): void {
    if (this.root.clientWidth < 2) {
      this.wantsFit = true;
      return;
    }
    this.wantsFit = false;
    this.camera.fit(this.drawnBoxes(), insetsOf(this.camera.mode));
    this.draw();
  }

  setMode(mode: '2d' | '3d'): void {
    this.camera.mode = mode;
    this.describe();
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
    this.render();
    const canvas = document.createElement('canvas');
    canvas.width = this.renderer.canvas.width;
    canvas.height = this.renderer.canvas.height;
    const context = canvas.getContext('2d');
    if (context === null) return '';
    context.drawImage(this.renderer.canvas, 0, 0);
    context.drawImage(this.overlay, 0, 0, canvas.width, canvas.height);
    return canvas.toDataURL('image/png');
  }

  frames(): FrameFigures {
    return { ...this.figures };
  }

  destroy(): void {
    cancelAnimationFrame(this.frame);
    this.observer.disconnect();
    this.disconnect();
    this.renderer.destroy();
    this.root.remove();
    this.paths = [];
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
    const ratio = Math.min(3, Math.max(1, window.devicePixelRatio || 1));
    const keepsScale = this.camera.width > 1 && !this.wantsFit;
    const grown = Math.min(width / this.camera.width, height / this.camera.height);
    this.camera.width = width;
    this.camera.height = height;
    if (keepsScale) this.camera.scale *= grown;
    this.renderer.resize(width, height, ratio);
    this.overlay.width = Math.round(width * ratio);
    this.overlay.height = Math.round(height * ratio);
    if (this.wantsFit) this.fit();
    this.render();
  }

  private moved(): void {
    this.draw();
  }

  /** Makes the next frame choose its nodes again. */
  private forget(): void {
    this.shownCode = this.litCode = -1;
    this.draw();
  }

  private findDrawn(): void {
    this.drawnChunks = this.paths.map((path) => {
      const drawn = new Uint8Array(path.chunks);
      for (let c = 0; c < path.chunks; c++) drawn[c] = path.hasDrawn(c) ? 1 : 0;
      return drawn;
    });
    this.forget();
  }

  private *drawnBoxes(): Generator<Box> {
    for (const [k, path] of this.paths.entries()) {
      for (let c = 0; c < path.chunks; c++) if (this.drawnChunks[k]![c]) yield path.box(c);
    }
  }

  private draw(): void {
    if (this.frame !== 0) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.render();
    });
  }

  private render(): void {
    if (this.camera.width < 2) return;
    const start = performance.now();
    const follows = start - this.lastFrameAt < kContinuousMs;
    this.chooseNodes();
    this.chooseLit();
    const radius = this.box === null ? 1 : Math.hypot(...this.box.high);
    this.renderer.draw(this.camera, this.theme, radius);
    this.renderOverlay();
    this.figures = {
      vertices: 2 * (this.strips.strips.count + this.lit.strips.count),
      level: Math.max(0, this.shownCode - finestCode(this.camera.scale)),
      lastFrameMs: follows ? start - this.lastFrameAt : performance.now() - start,
    };
    this.lastFrameAt = start;
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

  private chooseNodes(): void {
    this.paths.forEach((path, k) => {
      markChunks(path, this.camera, this.drawnChunks[k]!, this.marks[k]!);
    });
    const budget = kMostNodes - (this.ranges.length > 0 ? kHighlightNodes : 0);
    let code = chooseCode(this.paths, this.marks, this.camera.scale, budget);
    if (code === this.shownCode && this.shownMarks.length === this.marks.length &&
      this.marks.every((marks, k) => isSame(marks, this.shownMarks[k]!))) return;
    const chosen = code;
    for (; ; code++) {
      this.strips.clear();
      const all = this.paths.every((path, k) => addChunks(this.strips, path, this.marks[k]!, code));
      if ((all && this.strips.strips.count <= budget) || code >= 63) break;
    }
    this.shownCode = chosen;
    this.shownMarks = this.marks.map((marks) => marks.slice());
    this.renderer.setStrips(0, this.strips.strips);
  }

  private chooseLit(): void {
    const finest = finestCode(this.camera.scale);
    if (finest === this.litCode) return;
    this.litCode = finest;
    for (let code = finest; code < 64; code++) {
      this.lit.clear();
      if (this.ranges.every((range) => this.addRange(range, code))) break;
    }
    this.renderer.setStrips(1, this.lit.strips);
  }

  /** Adds one highlighted stretch; its ends are interpolated between nodes. */
  private addRange(range: PathRange, code: number): boolean {
    const path = this.paths[range.layer];
    this.lit.end();
    if (path === undefined || path.count < 2 || range.to < range.from) return true;
    const first = nodeAtRow(path, range.from), last = nodeAtRow(path, range.to);
    const begin = positionAtRow(path, range.from), finish = positionAtRow(path, range.to);
    const p = path.position;
    const join = (from: ArrayLike<number>, a: number, to: ArrayLike<number>, b: number): boolean => {
      const length = Math.hypot(to[b]! - from[a]!, to[b + 1]! - from[a + 1]!,
        to[b + 2]! - from[a + 2]!);
      return length === 0 || this.lit.add(from, a, to, b, length, kBlack, 0, 0);
    };
    if (first >= last) return join(begin, 0, finish, 0);
    return join(begin, 0, p, 3 * first) && addNodes(this.lit, path, first, last - 1, code) &&
      join(p, 3 * (last - 1), finish, 0);
  }
}

const kBlack = [0, 0, 0];

function newCanvas(): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  canvas.style.cssText = 'position:absolute;left:0;top:0;width:100%;height:100%;';
  return canvas;
}

function isSame(a: Uint8Array, b: Uint8Array): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

/** Returns the box of all nodes in mm, or null where there is none. */
function boxOf(layers: PathLayer[]): Box | null {
  const low: Vector = [Infinity, Infinity, Infinity];
  const high: Vector = [-Infinity, -Infinity, -Infinity];
  for (const layer of layers) {
    [layer.x, layer.y, layer.z].forEach((values, k) => {
      for (const value of values) {
        if (value < low[k]!) low[k] = value;
        if (value > high[k]!) high[k] = value;
      }
    });
  }
  return low[0] <= high[0] ? { low, high } : null;
}
