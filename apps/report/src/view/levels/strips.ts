// SPDX-License-Identifier: MIT
// Chooses the nodes of a frame from the levels of detail and joins them to strips.

import type { Camera } from '../common/camera.ts';
import { codeOfError, kCodes, kRapid } from './codes.ts';
import { kCellsPerChunk, type PathLevels } from './levels.ts';

export const kMostVertices = 40000;
/** A node of a strip is drawn as two vertices, left and right of the path. */
export const kMostNodes = kMostVertices / 2;

/** Bits of the fourth byte of `look`. */
export const kBegins = 1; // No interval leads to this node from the one before.
export const kIsRapid = 2;

/** Polylines one after another; all arrays have `count` entries (times 3, 1 and 4). */
export interface Strips {
  count: number;
  position: Float32Array;
  /** Path length from the begin of the strip, in mm. */
  along: Float32Array;
  /** Red, green, blue of the interval that ends in the node, and bits. */
  look: Uint8Array;
}

const kFinestErrorPx = 0.2;
const kSharpCosine = -0.3;

/** Collects strips. */
export class StripBuilder {
  readonly strips: Strips;
  readonly capacity: number;
  private open = false;
  private length = 0;

  constructor(capacity: number) {
    this.capacity = capacity;
    this.strips = {
      count: 0,
      position: new Float32Array(3 * capacity),
      along: new Float32Array(capacity),
      look: new Uint8Array(4 * capacity),
    };
  }

  clear(): void {
    this.strips.count = 0;
    this.open = false;
  }

  /** Ends the strip: the next interval begins another one. */
  end(): void {
    this.open = false;
  }

  /** Adds the interval from one point to another; returns false where there is no space left. */
  add(from: ArrayLike<number>, a: number, to: ArrayLike<number>, b: number, length: number,
    rgb: ArrayLike<number>, colour: number, bits: number): boolean {
    if (this.strips.count + 2 > this.capacity) return false;
    if (!this.open) {
      this.length = 0;
      this.node(from, a, rgb, colour, bits | kBegins);
      this.open = true;
    } else if (this.isSharp(to, b)) {
      this.node(from, a, rgb, colour, bits | kBegins);
    }
    this.length += length;
    this.node(to, b, rgb, colour, bits);
    return true;
  }

  private node(p: ArrayLike<number>, at: number, rgb: ArrayLike<number>, colour: number,
    bits: number): void {
    const s = this.strips, n = s.count++;
    s.position[3 * n] = p[at]!;
    s.position[3 * n + 1] = p[at + 1]!;
    s.position[3 * n + 2] = p[at + 2]!;
    s.along[n] = this.length;
    s.look[4 * n] = rgb[colour]!;
    s.look[4 * n + 1] = rgb[colour + 1]!;
    s.look[4 * n + 2] = rgb[colour + 2]!;
    s.look[4 * n + 3] = bits;
  }

  /** Whether the path turns back at the last node: a joined strip would be twisted there. */
  private isSharp(to: ArrayLike<number>, b: number): boolean {
    const s = this.strips, n = s.count - 1;
    if (n < 1 || (s.look[4 * n + 3]! & kBegins) !== 0) return false;
    const p = s.position;
    let dot = 0, aa = 0, bb = 0;
    for (let k = 0; k < 3; k++) {
      const u = p[3 * n + k]! - p[3 * n - 3 + k]!;
      const v = to[b + k]! - p[3 * n + k]!;
      dot += u * v; aa += u * u; bb += v * v;
    }
    return dot < kSharpCosine * Math.sqrt(aa * bb);
  }
}

/** Marks the cells whose boxes touch the screen and that show anything. */
export function markCells(path: PathLevels, camera: Camera, marks: Uint8Array): void {
  const { right, up } = camera.basis();
  const [tx, ty, tz] = camera.target;
  const halfWidth = camera.width / 2 / camera.scale, halfHeight = camera.height / 2 / camera.scale;
  const margin = 8 / camera.scale;
  const b = path.boxes;
  for (let c = 0; c < path.cells; c++) {
    const at = 6 * c;
    const x = (b[at]! + b[at + 3]!) / 2 - tx, ex = (b[at + 3]! - b[at]!) / 2;
    const y = (b[at + 1]! + b[at + 4]!) / 2 - ty, ey = (b[at + 4]! - b[at + 1]!) / 2;
    const z = (b[at + 2]! + b[at + 5]!) / 2 - tz, ez = (b[at + 5]! - b[at + 2]!) / 2;
    const px = Math.abs(right[0] * x + right[1] * y + right[2] * z);
    const py = Math.abs(up[0] * x + up[1] * y + up[2] * z);
    const sx = Math.abs(right[0]) * ex + Math.abs(right[1]) * ey + Math.abs(right[2]) * ez;
    const sy = Math.abs(up[0]) * ex + Math.abs(up[1]) * ey + Math.abs(up[2]) * ez;
    const seen = px - sx <= halfWidth + margin && py - sy <= halfHeight + margin;
    marks[c] = seen && path.drawnLength[c]! > 0 ? 1 : 0;
  }
}

/** Returns the length of what is drawn in the marked cells, in mm. */
export function markedLength(path: PathLevels, marks: Uint8Array): number {
  let total = 0;
  for (let c = 0; c < path.cells; c++) if (marks[c] !== 0) total += path.drawnLength[c]!;
  return total;
}

/** Leaves marks in every `every`-th chunk at most. */
export function keepEvery(marks: Uint8Array, every: number): void {
  for (let c = 0; c < marks.length; c++) {
    if (Math.floor(c / kCellsPerChunk) % every !== 0) marks[c] = 0;
  }
}

/** Returns about how many nodes of at least this code the marked cells have. */
function countNodes(path: PathLevels, marks: Uint8Array, code: number): number {
  let total = 0;
  for (let c = 0; c < path.chunks; c++) {
    let marked = 0, ends = 0;
    const first = c * kCellsPerChunk, last = Math.min(path.cells, first + kCellsPerChunk);
    for (let cell = first; cell < last; cell++) {
      if (marks[cell] === 0) continue;
      marked++;
      if (cell + 1 === path.cells || marks[cell + 1] === 0) ends++;
    }
    if (marked > 0) total += path.counts[c * kCodes + code]! * marked / (last - first) + ends;
  }
  return total;
}

/** Returns the smallest code, at least that of the finest error, whose nodes are within budget. */
export function chooseCode(paths: PathLevels[], marks: Uint8Array[], scale: number,
  budget: number): number {
  let code = finestCode(scale);
  while (code < kCodes - 1) {
    let total = 0;
    paths.forEach((path, k) => { total += countNodes(path, marks[k]!, code); });
    if (total <= budget) break;
    code++;
  }
  return code;
}

/** Returns the code of the smallest error that can be seen at this scale (CSS px per mm). */
export function finestCode(scale: number): number {
  return Math.max(1, codeOfError(kFinestErrorPx / scale));
}

/** Adds the marked cells at this code; returns false where there is no space left. */
export function addCells(builder: StripBuilder, path: PathLevels, marks: Uint8Array, code: number,
  first = 0, last = path.count - 1): boolean {
  const { cellSize } = path;
  for (let from = first; from < last;) {
    let cell = Math.floor(from / cellSize);
    if (marks[cell] === 0) {
      builder.end();
      from = (cell + 1) * cellSize;
      continue;
    }
    while (cell + 1 < path.cells && marks[cell + 1] !== 0) cell++;
    const to = Math.min(last, path.lastOfCell(cell));
    if (!addNodes(builder, path, from, to, code)) return false;
    from = to;
  }
  return true;
}

/** Adds the intervals between two nodes at this code, both ends included. */
export function addNodes(builder: StripBuilder, path: PathLevels, first: number, last: number,
  code: number): boolean {
  const p = path.position;
  let from = first;
  for (let i = first + 1; i <= last; i++) {
    if (i < last && path.code[i]! < code) continue;
    const shown = path.conspicuous(from, i);
    if (shown >= 0) {
      const length = Math.hypot(p[3 * i]! - p[3 * from]!, p[3 * i + 1]! - p[3 * from + 1]!,
        p[3 * i + 2]! - p[3 * from + 2]!);
      const bits = path.motion[shown] === kRapid ? kIsRapid : 0;
      const added = length === 0 ||
        builder.add(p, 3 * from, p, 3 * i, length, path.rgb, 3 * shown, bits);
      if (!added) return false;
    } else if (hasLength(path, from, i)) {
      builder.end();
    }
    from = i;
  }
  return true;
}

function hasLength(path: PathLevels, from: number, to: number): boolean {
  for (let i = from + 1; i <= to; i++) if (path.length[i]! > 0) return true;
  return false;
}
