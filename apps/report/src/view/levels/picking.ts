// SPDX-License-Identifier: MIT
// Finds the place of a path that is nearest to the pointer, and the place of a row.

import type { Camera, Vector } from '../common/camera.ts';
import { kCutting } from './codes.ts';
import type { PathLevels } from './levels.ts';
import type { PathHit } from './path_types.ts';

const kReach = 10; // CSS px.
const kSameDistance = 1.5; // CSS px: of paths this near to one another the frontmost is taken.
const kRapidPenalty = 3; // CSS px: a cutting move is preferred to a rapid.

/** Returns the nearest drawn place of any path within 10 CSS pixels, or null. */
export function pick(paths: PathLevels[], camera: Camera, px: number, py: number): PathHit | null {
  const { right, up, towards } = camera.basis();
  const [tx, ty, tz] = camera.target;
  const wantedX = (px - camera.width / 2) / camera.scale;
  const wantedY = (camera.height / 2 - py) / camera.scale;
  const reach = kReach / camera.scale, same = kSameDistance / camera.scale;
  let best: PathHit | null = null;
  let bestDistance = reach, bestFront = -Infinity;
  const along = (v: Vector, x: number, y: number, z: number): number =>
    v[0] * (x - tx) + v[1] * (y - ty) + v[2] * (z - tz);
  paths.forEach((path, layer) => {
    for (let c = 0; c < path.cells; c++) {
      if (!isCellNear(path, c, right, up, camera.target, wantedX, wantedY, reach)) continue;
      const p = path.position;
      for (let i = c * path.cellSize + 1; i <= path.lastOfCell(c); i++) {
        if (path.length[i] === 0 || !path.isDrawn(i)) continue;
        const k = 3 * i;
        const ax = along(right, p[k - 3]!, p[k - 2]!, p[k - 1]!) - wantedX;
        const ay = along(up, p[k - 3]!, p[k - 2]!, p[k - 1]!) - wantedY;
        const dx = along(right, p[k]!, p[k + 1]!, p[k + 2]!) - wantedX - ax;
        const dy = along(up, p[k]!, p[k + 1]!, p[k + 2]!) - wantedY - ay;
        const dd = dx * dx + dy * dy;
        const t = dd > 0 ? Math.min(1, Math.max(0, -(ax * dx + ay * dy) / dd)) : 0;
        let distance = Math.hypot(ax + t * dx, ay + t * dy);
        if (distance > bestDistance + same || distance > reach) continue;
        if (path.motion[i] !== kCutting) distance += kRapidPenalty / camera.scale;
        if (distance > bestDistance + same) continue;
        const a = along(towards, p[k - 3]!, p[k - 2]!, p[k - 1]!);
        const b = along(towards, p[k]!, p[k + 1]!, p[k + 2]!);
        const front = a + t * (b - a);
        const isClear = distance < bestDistance - same;
        if (best !== null && !isClear && front < bestFront) continue;
        best = { layer, row: path.row[i - 1]! + t * (path.row[i]! - path.row[i - 1]!) };
        bestDistance = Math.min(distance, isClear ? distance : bestDistance);
        bestFront = front;
      }
    }
  });
  return best;
}

function isCellNear(path: PathLevels, cell: number, right: Vector, up: Vector, target: Vector,
  x: number, y: number, reach: number): boolean {
  const b = path.boxes, at = 6 * cell;
  let sx = -x, sy = -y, ex = reach, ey = reach;
  for (let k = 0; k < 3; k++) {
    const middle = (b[at + k]! + b[at + 3 + k]!) / 2 - target[k]!;
    const half = (b[at + 3 + k]! - b[at + k]!) / 2;
    sx += right[k]! * middle;
    sy += up[k]! * middle;
    ex += Math.abs(right[k]!) * half;
    ey += Math.abs(up[k]!) * half;
  }
  return Math.abs(sx) <= ex && Math.abs(sy) <= ey;
}

/** Returns the first node whose row is at least `row`, at most the last node. */
export function nodeAtRow(path: PathLevels, row: number): number {
  let low = 0, high = path.count - 1;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (path.row[middle]! < row) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Returns the position at a row, in mm from the centre, interpolated between nodes. */
export function positionAtRow(path: PathLevels, row: number): Vector {
  const b = nodeAtRow(path, row), a = Math.max(0, b - 1);
  const span = path.row[b]! - path.row[a]!;
  const t = span > 0 ? Math.min(1, Math.max(0, (row - path.row[a]!) / span)) : 1;
  const p = path.position;
  const at = (k: number): number => p[3 * a + k]! + t * (p[3 * b + k]! - p[3 * a + k]!);
  return [at(0), at(1), at(2)];
}
