// SPDX-License-Identifier: MIT
// What a picture of paths shows beside them: the tool at a row of each, and scenery.

import type { Box, Vector } from '../common/camera.ts';
import type { PathLevels } from '../levels/levels.ts';
import type { Scenery } from '../levels/path_types.ts';
import { positionAtRow } from '../levels/picking.ts';
import { boxOfOutlines } from './outlines.ts';

export class Marks {
  /** Row of the tool on each path; null where it is not shown. */
  rows: Array<number | null> = [];
  scenery: Scenery = { outlines: [], origins: [] };

  /** Returns the places of the tools. */
  tools(paths: PathLevels[]): Vector[] {
    return paths.flatMap((path, k) => {
      const row = this.rows[k] ?? null;
      return row === null || path.count === 0 ? [] : [positionAtRow(path, row)];
    });
  }

  /** Returns what a fitted picture has to show of the outlines. */
  box(centre: Vector): Box | null {
    return boxOfOutlines(this.scenery.outlines, centre);
  }
}
