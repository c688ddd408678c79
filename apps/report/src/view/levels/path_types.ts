// SPDX-License-Identifier: MIT
// What the view of a path takes and gives.

import type { Side } from '../common/camera.ts';

/** Numbers of one column of the nodes of a path. */
export type Coordinates = Float32Array | Float64Array;

/** The path of one run: all arrays have one entry per node. */
export interface PathLayer {
  /** Position of the node, in mm. */
  x: Coordinates;
  y: Coordinates;
  z: Coordinates;
  /** Period number of the node; never falls. */
  row: Float64Array;
  /** Motion of the interval that ends in the node: 0 rest, 1 cutting, 2 rapid. */
  motion: Uint8Array;
}

/** Lines beside the paths, in mm: six numbers for each edge, x1 y1 z1 x2 y2 z2. */
export interface Outline {
  name: string;
  look: 'travel' | 'workpiece';
  edges: number[];
}

/** The origin of a work system, in mm. */
export interface Origin {
  name: string;
  at: [number, number, number];
}

/** What stands beside the paths. */
export interface Scenery {
  outlines: Outline[];
  origins: Origin[];
}

/** A place on a path: the row is interpolated within the interval. */
export interface PathHit {
  layer: number;
  row: number;
}

/** A stretch of a path in rows; its ends are interpolated between nodes. */
export interface PathRange {
  layer: number;
  from: number;
  to: number;
}

/** Receives the place that the pointer is at, or null where no path is near. */
export type HitListener = (hit: PathHit | null, event: PointerEvent) => void;

/** What the last frame has drawn. */
export interface FrameFigures {
  /** Vertices that were drawn: by WebGL two for each node of a strip and pass. */
  vertices: number;
  /** Level of detail, 0 the finest; each level doubles the allowed error every second step. */
  level: number;
  /** Time from the frame before where frames follow one another, otherwise time of drawing. */
  lastFrameMs: number;
}

/** An interactive picture of one or two paths. */
export interface PathView {
  /** Replaces the paths; colours, visibility, highlight and markers are reset. */
  setLayers(layers: PathLayer[]): void;
  /** Sets the colours of a layer: three bytes per node, for the interval that ends in it. */
  setColours(layer: number, rgb: Uint8Array): void;
  /** Shows only intervals whose entry is not 0; null shows all. */
  setVisible(layer: number, visible: Uint8Array | null): void;
  /** Draws these stretches thick above all others. */
  highlight(ranges: PathRange[]): void;
  /** Shows the tool at this row; null removes it. */
  setMarker(layer: number, row: number | null): void;
  /** Shows this beside the paths, and nothing else. */
  setScenery(scenery: Scenery): void;
  /** Moves the camera so that all visible intervals and the outlines are within the picture. */
  fit(): void;
  /** Looks from above ('2d') or from a direction that the user turns ('3d'). */
  setMode(mode: '2d' | '3d'): void;
  /** Looks in space from a side. */
  lookFrom(side: Side): void;
  /** Calls back when the user has turned the picture. */
  onTurn(callback: () => void): void;
  setTheme(dark: boolean): void;
  /** Calls back at a click, with the nearest path within 10 CSS pixels. */
  onPick(callback: HitListener): void;
  /** Calls back when the pointer has moved over the picture or left it. */
  onHover(callback: HitListener): void;
  /** Returns the picture as a data URL (PNG). */
  toImage(): string;
  frames(): FrameFigures;
  /** Removes the picture and all its listeners. */
  destroy(): void;
}
