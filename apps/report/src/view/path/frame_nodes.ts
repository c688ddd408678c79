// SPDX-License-Identifier: MIT
// Chooses what a frame draws: nodes of all paths, and of the highlighted stretches.

import type { Box, Camera } from '../common/camera.ts';
import type { PathLevels } from '../levels/levels.ts';
import type { PathRange } from '../levels/path_types.ts';
import { nodeAtRow, positionAtRow } from '../levels/picking.ts';
import {
  addCells, chooseCode, finestCode, keepEvery, kMostNodes, markCells, markedLength, StripBuilder,
} from '../levels/strips.ts';
import { kLineWidth } from '../lines/renderer.ts';

const kHighlightNodes = kMostNodes / 4;
const kCoarsest = 63;
// A slow browser leaves out chunks of paths that cover their part of the screen more often.
const kEnoughCoverage = 1.2;
const kBlack = [0, 0, 0];

/** What of the nodes has changed since the frame before. */
export interface Changes {
  strips: boolean;
  lit: boolean;
}

/** The nodes of the frame; they are chosen again only where the frame needs others. */
export class FrameNodes {
  readonly strips = new StripBuilder(kMostNodes);
  readonly lit = new StripBuilder(kHighlightNodes);
  /** How often the paths cover the part of the screen that their box takes. */
  coverage = 0;
  private paths: PathLevels[] = [];
  private ranges: PathRange[] = [];
  private marks: Uint8Array[] = [];
  private shownMarks: Uint8Array[] = [];
  private shownCode = -1;
  private litMarks: Uint8Array[] = [];
  private litCode = -1;

  setPaths(paths: PathLevels[]): void {
    this.paths = paths;
    this.ranges = [];
    this.marks = paths.map((path) => new Uint8Array(path.cells));
    this.forget();
  }

  setRanges(ranges: PathRange[]): void {
    this.ranges = ranges.slice();
    this.litCode = -1;
  }

  /** Makes the next frame choose its nodes again. */
  forget(): void {
    this.shownCode = this.litCode = -1;
  }

  /** Returns the level of detail of the frame, 0 the finest. */
  level(camera: Camera): number {
    return Math.max(0, this.shownCode - finestCode(camera.scale));
  }

  /** Chooses the nodes; `quality` below 1 leaves some out, for a slow browser. */
  choose(camera: Camera, box: Box | null, quality: number): Changes {
    this.paths.forEach((path, k) => {
      path.rank();
      markCells(path, camera, this.marks[k]!);
    });
    const lit = this.chooseLit(camera);
    this.coverage = this.findCoverage(camera, box);
    const every = quality < 1 ? Math.round(this.coverage / kEnoughCoverage) : 1;
    if (every > 1) this.marks.forEach((marks) => keepEvery(marks, every));
    return { strips: this.chooseStrips(camera, quality), lit };
  }

  private chooseStrips(camera: Camera, quality: number): boolean {
    const most = kMostNodes - (this.ranges.length > 0 ? kHighlightNodes : 0);
    const budget = Math.round(most * quality);
    const chosen = chooseCode(this.paths, this.marks, camera.scale, budget);
    if (chosen === this.shownCode && areSame(this.marks, this.shownMarks)) return false;
    for (let code = chosen; code <= kCoarsest; code++) {
      this.strips.clear();
      const all = this.paths.every((path, k) => {
        this.strips.end();
        return addCells(this.strips, path, this.marks[k]!, code);
      });
      if (all && this.strips.strips.count <= budget) break;
    }
    this.shownCode = chosen;
    this.shownMarks = this.marks.map((marks) => marks.slice());
    return true;
  }

  private chooseLit(camera: Camera): boolean {
    const finest = finestCode(camera.scale);
    if (finest === this.litCode && (this.ranges.length === 0 || areSame(this.marks, this.litMarks))) {
      return false;
    }
    this.litCode = finest;
    this.litMarks = this.marks.map((marks) => marks.slice());
    for (let code = finest; code <= kCoarsest; code++) {
      this.lit.clear();
      if (this.ranges.every((range) => this.addRange(range, code))) break;
    }
    return true;
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
    const marks = this.litMarks[range.layer]!;
    return join(begin, 0, p, 3 * first) &&
      addCells(this.lit, path, marks, code, first, last - 1) && join(p, 3 * (last - 1), finish, 0);
  }

  private findCoverage(camera: Camera, box: Box | null): number {
    if (box === null) return 0;
    const { low, high } = box;
    const xs: number[] = [], ys: number[] = [];
    for (let k = 0; k < 8; k++) {
      const [x, y] = camera.project(k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1],
        k & 4 ? high[2] : low[2]);
      xs.push(Math.min(camera.width, Math.max(0, x)));
      ys.push(Math.min(camera.height, Math.max(0, y)));
    }
    const area = (Math.max(...xs) - Math.min(...xs)) * (Math.max(...ys) - Math.min(...ys));
    let total = 0;
    this.paths.forEach((path, k) => { total += markedLength(path, this.marks[k]!); });
    return total * camera.scale * kLineWidth / Math.max(100, area);
  }
}

function areSame(a: Uint8Array[], b: Uint8Array[]): boolean {
  return a.length === b.length && a.every((values, k) => {
    const other = b[k]!;
    return values.length === other.length && values.every((value, i) => value === other[i]);
  });
}
