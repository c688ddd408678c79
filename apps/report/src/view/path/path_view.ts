// SPDX-License-Identifier: MIT
// The picture of one or two paths: camera, levels of detail, renderer, overlay and gestures.

import { Camera, type Box, type Side, type Vector } from '../common/camera.ts';
import { connectGestures } from '../common/gestures.ts';
import { themeOf } from '../common/theme.ts';
import { PathLevels } from '../levels/levels.ts';
import type {
  FrameFigures, HitListener, PathLayer, PathRange, PathView, Scenery,
} from '../levels/path_types.ts';
import { pick, positionAtRow } from '../levels/picking.ts';
import { centreOf, farthest, joinBoxes } from './boxes.ts';
import { Canvases, deviceRatio } from './canvases.ts';
import { FrameNodes } from './frame_nodes.ts';
import { Marks } from './marks.ts';
import { MotionQuality } from './motion_quality.ts';
import { drawOverlay, insetsOf } from './overlay.ts';
import { Pointer } from './pointer.ts';
import { steering } from './steering.ts';

export type {
  FrameFigures, HitListener, PathHit, PathLayer, PathRange, PathView,
} from '../levels/path_types.ts';

const kPrintRatio = 2; // Pixels per CSS pixel of the image for printing.
const kContinuousMs = 800; // Frames further apart than this do not follow one another.

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
  private readonly camera = new Camera();
  private readonly canvases: Canvases;
  private readonly nodes = new FrameNodes();
  private readonly quality = new MotionQuality();
  private readonly pointer =
    new Pointer(this.root, (x, y) => pick(this.paths, this.camera, x, y));
  private readonly observer: ResizeObserver;
  private readonly disconnect: () => void;
  private turned: (() => void) | null = null;
  private paths: PathLevels[] = [];
  private centre: Vector = [0, 0, 0];
  private box: Box | null = null;
  private readonly marks = new Marks();
  private theme = themeOf(false, document.documentElement);
  private isDark = false;
  private frame = 0;
  private lastFrameAt = -Infinity;
  private wantsFit = true;
  private wantsPaths = true;
  private figures: FrameFigures = { vertices: 0, level: 0, lastFrameMs: 0 };

  constructor(container: HTMLElement) {
    this.container = container;
    const root = this.root;
    root.style.cssText = 'position:absolute;inset:0;overflow:hidden;';
    root.tabIndex = 0;
    root.setAttribute('role', 'application');
    if (getComputedStyle(container).position === 'static') container.style.position = 'relative';
    this.canvases = new Canvases(root, this.camera, () => {
      this.forget();
      this.resize();
    });
    container.append(root);
    this.describe();
    this.theme = themeOf(false, container);
    this.disconnect = connectGestures(root, steering(this.camera, this.pointer, {
      moved: () => this.moved(),
      turned: () => this.turned?.(),
      fit: () => this.fit(),
    }));
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
    this.marks.rows = layers.map(() => null);
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
    this.marks.rows[layer] = row;
    this.schedule();
  }

  setScenery(scenery: Scenery): void {
    this.marks.scenery = scenery;
    this.schedule();
  }

  fit(): void {
    if (this.root.clientWidth < 2) {
      this.wantsFit = true;
      return;
    }
    this.wantsFit = false;
    const box = joinBoxes(this.box, this.marks.box(this.centre));
    if (box !== null) this.camera.fit(box, insetsOf(this.camera.mode));
    this.draw();
  }

  setMode(mode: '2d' | '3d'): void {
    this.camera.mode = mode;
    this.directed();
  }

  lookFrom(side: Side): void {
    this.camera.lookFrom(side);
    this.directed();
  }

  onTurn(callback: () => void): void {
    this.turned = callback;
  }

  setTheme(dark: boolean): void {
    this.isDark = dark;
    this.theme = themeOf(dark, this.container);
    this.draw();
  }

  onPick(callback: HitListener): void {
    this.pointer.onPick = callback;
  }

  onHover(callback: HitListener): void {
    this.pointer.onHover = callback;
  }

  toImage(): string {
    this.setSize(Math.max(kPrintRatio, deviceRatio()));
    this.render();
    const image = this.canvases.image();
    this.setSize(deviceRatio());
    this.draw();
    return image;
  }

  frames(): FrameFigures {
    return { ...this.figures };
  }

  destroy(): void {
    cancelAnimationFrame(this.frame);
    this.quality.stop();
    this.observer.disconnect();
    this.disconnect();
    this.canvases.renderer.destroy();
    this.root.remove();
    this.paths = [];
  }

  /** Shows the paths from a direction that the user has not turned the camera to. */
  private directed(): void {
    this.paths.forEach((path) => path.setFlat(this.camera.mode === '2d'));
    this.describe();
    this.nodes.forget();
    this.fit();
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
    this.canvases.setSize(ratio);
    this.wantsPaths = true;
  }

  /** Draws while the picture moves, coarser where the browser is slow. */
  private moved(): void {
    this.quality.move(() => {
      this.canvases.setPart(1);
      this.draw();
    });
    this.draw();
  }

  /** Makes the next frame choose its nodes again. */
  private forget(): void {
    this.nodes.forget();
    this.draw();
  }

  private findDrawn(): void {
    this.box = this.paths.map((path) => path.drawnBox()).reduce(joinBoxes, null);
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
    this.canvases.setPart(part < 1 ? 1 / deviceRatio() : 1);
    const changes = this.nodes.choose(this.camera, this.box, part);
    const { renderer } = this.canvases;
    if (changes.strips) renderer.setStrips(0, this.nodes.strips.strips);
    if (changes.lit) renderer.setStrips(1, this.nodes.lit.strips);
    const vertices = renderer.draw(this.camera, this.theme, {
      radius: Math.hypot(...farthest(this.box)), coverage: this.nodes.coverage, isCoarse: part < 1,
    });
    this.figures = {
      vertices,
      level: this.nodes.level(this.camera),
      lastFrameMs: follows ? sinceLast : performance.now() - start,
    };
    this.lastFrameAt = start;
  }

  private renderOverlay(): void {
    const context = this.canvases.overlayContext();
    if (context === null) return;
    drawOverlay(context, this.camera, {
      box: this.box, centre: this.centre, markers: this.marks.tools(this.paths),
      ...this.marks.scenery, isDark: this.isDark, theme: this.theme,
    });
  }
}
