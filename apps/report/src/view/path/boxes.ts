// SPDX-License-Identifier: MIT
// The boxes that paths lie in.

import type { Box, Vector } from '../common/camera.ts';
import type { PathLayer } from '../levels/path_types.ts';

/** Returns the box of both; null is an empty box. */
export function joinBoxes(a: Box | null, b: Box | null): Box | null {
  if (a === null || b === null) return a ?? b;
  const pick = (f: (a: number, b: number) => number, u: Vector, v: Vector): Vector =>
    [f(u[0], v[0]), f(u[1], v[1]), f(u[2], v[2])];
  return { low: pick(Math.min, a.low, b.low), high: pick(Math.max, a.high, b.high) };
}

/** Returns the largest distance of the box from 0 along each axis, in mm. */
export function farthest(box: Box | null): Vector {
  const { low, high } = box ?? { low: [0, 0, 0], high: [0, 0, 0] };
  return [0, 1, 2].map((k) => Math.max(-low[k]!, high[k]!)) as Vector;
}

/** Returns the middle of the box of all nodes, in mm. */
export function centreOf(layers: PathLayer[]): Vector {
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
