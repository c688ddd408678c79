// SPDX-License-Identifier: MIT
// Levels of detail of one path: which of its nodes a picture needs at which allowed error.
//
// The nodes are cut into cells of equal count with a box each, to leave out what is not on the
// screen, and several cells make a chunk. Within a chunk each node has a code that grows with the
// error that leaving it out causes: of the shape (`shape_rank.ts`), in space or as seen from above,
// and of the colours (`colour_rank.ts`). Two steps of the code double the error. A node is drawn at
// level k if its code is at least k; the ends of a chunk always are.

import type { Box, Vector } from '../common/camera.ts';
import { kCodes, kCutting, kRest } from './codes.ts';
import { kBlock, rankColours } from './colour_rank.ts';
import type { PathLayer } from './path_types.ts';
import { rankShape } from './shape_rank.ts';

const kSmallestChunk = 128;
const kMostChunks = 2048;
export const kCellsPerChunk = 8;

/** One path with what its levels of detail need; positions are in mm from `centre`. */
export class PathLevels {
  readonly count: number;
  readonly chunkSize: number;
  readonly chunks: number;
  readonly position: Float32Array;
  /** Length of the interval that ends in the node, in mm. */
  readonly length: Float32Array;
  readonly motion: Uint8Array;
  readonly row: Float64Array;
  readonly cellSize: number;
  readonly cells: number;
  /** Six numbers per cell: lowest x, y, z and highest x, y, z. */
  readonly boxes: Float32Array;
  /** Length of the intervals of each cell that are drawn, in mm. */
  readonly drawnLength: Float64Array;
  readonly code: Uint8Array;
  /** For each chunk and code: nodes of at least this code. */
  readonly counts: Uint32Array;
  rgb: Uint8Array;
  visible: Uint8Array | null = null;
  private shapeInSpace: Uint8Array | null = null;
  private shapeFromAbove: Uint8Array | null = null;
  private isFlat = false;
  private isRanked = false;
  private meanColour: Vector = [128, 128, 128];

  constructor(layer: PathLayer, centre: Vector) {
    const n = layer.row.length;
    this.count = n;
    let size = kSmallestChunk;
    while (n / size > kMostChunks) size *= 2;
    this.chunkSize = size;
    this.chunks = n < 2 ? 0 : Math.ceil((n - 1) / size);
    this.cellSize = size / kCellsPerChunk;
    this.cells = n < 2 ? 0 : Math.ceil((n - 1) / this.cellSize);
    this.position = new Float32Array(3 * n);
    this.length = new Float32Array(n);
    this.motion = layer.motion;
    this.row = layer.row;
    this.boxes = new Float32Array(6 * this.cells);
    this.drawnLength = new Float64Array(this.cells);
    this.code = new Uint8Array(n);
    this.counts = new Uint32Array(this.chunks * kCodes);
    this.rgb = new Uint8Array(3 * n).fill(128);
    this.place(layer, centre);
    for (let cell = 0; cell < this.cells; cell++) this.bound(cell);
    this.measure();
  }

  /** Ranks the nodes, if that is not done. Call before `code` and `counts` are read. */
  rank(): void {
    if (this.isRanked) return;
    this.isRanked = true;
    this.rankNodes();
  }

  /** Returns the index of the last node of a chunk; the next chunk begins with it. */
  lastNode(chunk: number): number {
    return Math.min(this.count - 1, (chunk + 1) * this.chunkSize);
  }

  /** Returns the index of the last node of a cell; the next cell begins with it. */
  lastOfCell(cell: number): number {
    return Math.min(this.count - 1, (cell + 1) * this.cellSize);
  }

  /** Returns whether the interval that ends in this node is drawn. */
  isDrawn(node: number): boolean {
    return this.motion[node] !== kRest && (this.visible === null || this.visible[node] !== 0);
  }

  setColours(rgb: Uint8Array): void {
    this.rgb = rgb;
    this.isRanked = false;
  }

  setVisible(visible: Uint8Array | null): void {
    this.visible = visible;
    this.isRanked = false;
    this.measure();
  }

  /** Chooses whether errors along z count: they are not seen from above. */
  setFlat(flat: boolean): void {
    if (this.isFlat === flat) return;
    this.isFlat = flat;
    this.isRanked = false;
  }

  /** Returns the box of all intervals that are drawn, or null where there are none. */
  drawnBox(): Box | null {
    const low: Vector = [Infinity, Infinity, Infinity];
    const high: Vector = [-Infinity, -Infinity, -Infinity];
    const p = this.position;
    const include = (at: number): void => {
      for (let k = 0; k < 3; k++) {
        const value = p[at + k]!;
        if (value < low[k]!) low[k] = value;
        if (value > high[k]!) high[k] = value;
      }
    };
    for (let i = 1; i < this.count; i++) {
      if (!this.isDrawn(i)) continue;
      if (!this.isDrawn(i - 1)) include(3 * i - 3);
      include(3 * i);
    }
    return low[0] <= high[0] ? { low, high } : null;
  }

  /**
   * Returns the node within (from, to] whose interval gives a merged interval its colour: the one
   * of the largest length, where a colour far from the mean of the path counts up to five times.
   * Cutting moves win over rapids. Returns -1 if none of the intervals is drawn.
   */
  conspicuous(from: number, to: number): number {
    if (to === from + 1) return this.isDrawn(to) ? to : -1;
    let best = -1, bestScore = -1;
    const [mr, mg, mb] = this.meanColour;
    for (let i = from + 1; i <= to; i++) {
      if (!this.isDrawn(i)) continue;
      let score = this.length[i]!;
      if (this.motion[i] === kCutting) {
        const contrast = Math.abs(this.rgb[3 * i]! - mr) + Math.abs(this.rgb[3 * i + 1]! - mg) +
          Math.abs(this.rgb[3 * i + 2]! - mb);
        score *= 1e3 * (1 + contrast / 96);
      }
      if (score > bestScore) {
        bestScore = score;
        best = i;
      }
    }
    return best;
  }

  private place({ x, y, z }: PathLayer, centre: Vector): void {
    const p = this.position;
    for (let i = 0; i < this.count; i++) {
      p[3 * i] = x[i]! - centre[0];
      p[3 * i + 1] = y[i]! - centre[1];
      p[3 * i + 2] = z[i]! - centre[2];
      if (i === 0) continue;
      const dx = x[i]! - x[i - 1]!, dy = y[i]! - y[i - 1]!, dz = z[i]! - z[i - 1]!;
      this.length[i] = Math.sqrt(dx * dx + dy * dy + dz * dz);
    }
  }

  private measure(): void {
    for (let cell = 0; cell < this.cells; cell++) {
      let length = 0;
      for (let i = cell * this.cellSize + 1; i <= this.lastOfCell(cell); i++) {
        if (this.isDrawn(i)) length += this.length[i]!;
      }
      this.drawnLength[cell] = length;
    }
  }

  private bound(cell: number): void {
    const b = this.boxes;
    const at = 6 * cell;
    const first = cell * this.cellSize, last = this.lastOfCell(cell);
    for (let k = 0; k < 3; k++) {
      let low = Infinity, high = -Infinity;
      for (let i = first; i <= last; i++) {
        const value = this.position[3 * i + k]!;
        if (value < low) low = value;
        if (value > high) high = value;
      }
      b[at + k] = low;
      b[at + 3 + k] = high;
    }
  }

  /** Returns the codes of the shape as it is seen: each is worked out when it is first needed. */
  private shapeCodes(): Uint8Array {
    const known = this.isFlat ? this.shapeFromAbove : this.shapeInSpace;
    if (known !== null) return known;
    const codes = new Uint8Array(this.count);
    for (let c = 0; c < this.chunks; c++) {
      rankShape(this.position, c * this.chunkSize, this.lastNode(c), this.isFlat ? 0 : 1, codes);
    }
    if (this.isFlat) this.shapeFromAbove = codes;
    else this.shapeInSpace = codes;
    return codes;
  }

  /** Ranks the nodes by colour, motion and visibility, and counts the nodes of each code. */
  private rankNodes(): void {
    this.findMeanColour();
    this.code.set(this.shapeCodes());
    const work = new Float32Array(kBlock * this.chunkSize);
    for (let c = 0; c < this.chunks; c++) {
      const first = c * this.chunkSize, last = this.lastNode(c);
      rankColours(this, first, last - first, work, this.code);
      this.code[first] = kCodes - 1;
      this.code[last] = kCodes - 1;
    }
    this.countCodes();
  }

  private findMeanColour(): void {
    let r = 0, g = 0, b = 0, total = 0;
    for (let i = 1; i < this.count; i++) {
      if (this.motion[i] !== kCutting) continue;
      const weight = this.length[i]!;
      r += weight * this.rgb[3 * i]!;
      g += weight * this.rgb[3 * i + 1]!;
      b += weight * this.rgb[3 * i + 2]!;
      total += weight;
    }
    if (total > 0) this.meanColour = [r / total, g / total, b / total];
  }

  private countCodes(): void {
    this.counts.fill(0);
    for (let c = 0; c < this.chunks; c++) {
      const at = c * kCodes;
      for (let i = c * this.chunkSize; i < this.lastNode(c); i++) this.counts[at + this.code[i]!]!++;
      for (let k = kCodes - 2; k >= 0; k--) this.counts[at + k]! += this.counts[at + k + 1]!;
    }
  }
}
