// SPDX-License-Identifier: MIT
// Reduces a column to what a chart can show: the least and the largest value of each pixel.
import { lowerBound } from './bisection.ts';

/** How the values between two nodes follow from those at the nodes. */
export type Between = 'linear' | 'interval';

/** An x axis cut into equal buckets. */
export interface Grid {
  from: number;
  to: number;
  buckets: number;
}

/** Returns the places of the two points that each bucket has: a quarter of it from its ends. */
export function gridPlaces({ from, to, buckets }: Grid): number[] {
  const width = (to - from) / buckets;
  return Array.from({ length: 2 * buckets }, (_, i) => from + ((i >> 1) + (i & 1 ? 0.75 : 0.25)) * width);
}

/**
 * Returns two values for each bucket: the least and the largest in it, in the order in which they
 * come, with the values at its ends counted in; null where the bucket lies outside `xs`, or where it
 * has no value (negative, if `hidden` is set). `xs` ascends; 'interval' values hold from the
 * previous node on.
 */
export function decimate(xs: ArrayLike<number>, ys: ArrayLike<number>, grid: Grid,
                         between: Between, factor = 1, hidden = false): Array<number | null> {
  const out: Array<number | null> = new Array(2 * grid.buckets).fill(null);
  const size = xs.length;
  if (size === 0) return out;
  const width = (grid.to - grid.from) / grid.buckets;
  let node = lowerBound(xs, grid.from);
  for (let bucket = 0; bucket < grid.buckets; ++bucket) {
    const low = grid.from + bucket * width;
    const high = low + width;
    if (low > xs[size - 1]! || high < xs[0]!) continue;
    let least = Infinity, most = -Infinity, leastAt = 0, mostAt = 0;
    const see = (value: number, at: number) => {
      if (hidden && value < 0) return;
      if (value < least) (least = value), (leastAt = at);
      if (value > most) (most = value), (mostAt = at);
    };
    const atEdge = (x: number, next: number) => {
      if (next >= size || (next === 0 && x < xs[0]!)) return;
      see(next === 0 || between === 'interval' ? ys[next]! : mixed(xs, ys, next, x), x);
    };
    atEdge(low, node);
    while (node < size && xs[node]! <= high) see(ys[node]!, xs[node++]!);
    atEdge(high, node);
    if (least > most) continue;
    out[2 * bucket] = factor * (leastAt <= mostAt ? least : most);
    out[2 * bucket + 1] = factor * (leastAt <= mostAt ? most : least);
  }
  return out;
}

function mixed(xs: ArrayLike<number>, ys: ArrayLike<number>, next: number, x: number): number {
  const part = (x - xs[next - 1]!) / (xs[next]! - xs[next - 1]!);
  return ys[next - 1]! + part * (ys[next]! - ys[next - 1]!);
}
