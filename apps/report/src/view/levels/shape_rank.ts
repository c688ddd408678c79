// SPDX-License-Identifier: MIT
// Codes of the errors of shape that leaving out a node causes.

import { codeOfError } from './codes.ts';

/**
 * Sets the codes of the nodes between `first` and `last` by the algorithm of Douglas and Peucker
 * (1973); a node's error never exceeds that of the split it lies within. `position` holds x, y and
 * z of each node in mm; distances along z count `weightOfZ` times.
 */
export function rankShape(position: Float32Array, first: number, last: number, weightOfZ: number,
  codes: Uint8Array): void {
  const p = position;
  const stack: number[] = [first, last, Infinity];
  while (stack.length > 0) {
    const limit = stack.pop()!, b = stack.pop()!, a = stack.pop()!;
    if (b - a < 2) continue;
    const ax = p[3 * a]!, ay = p[3 * a + 1]!, az = p[3 * a + 2]!;
    const ux = p[3 * b]! - ax, uy = p[3 * b + 1]! - ay, uz = (p[3 * b + 2]! - az) * weightOfZ;
    const uu = ux * ux + uy * uy + uz * uz;
    let worst = -1, at = (a + b) >> 1;
    for (let i = a + 1; i < b; i++) {
      let x = p[3 * i]! - ax, y = p[3 * i + 1]! - ay, z = (p[3 * i + 2]! - az) * weightOfZ;
      let t = uu > 0 ? (x * ux + y * uy + z * uz) / uu : 0;
      t = t < 0 ? 0 : t > 1 ? 1 : t;
      x -= t * ux; y -= t * uy; z -= t * uz;
      const d = x * x + y * y + z * z;
      if (d > worst) {
        worst = d;
        at = i;
      }
    }
    const error = Math.min(limit, Math.sqrt(Math.max(0, worst)));
    codes[at] = codeOfError(error);
    if (error <= 0) continue;
    stack.push(a, at, error, at, b, error);
  }
}
