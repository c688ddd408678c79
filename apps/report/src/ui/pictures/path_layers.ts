// SPDX-License-Identifier: MIT
// What the picture of the paths takes from the runs.
import type {RunModel} from '../../data/run_model.ts';
import type {PathLayer} from '../../view/path/path_view.ts';

/** Returns the path of a run. */
export function layerOf(run: RunModel): PathLayer {
  return {
    x: run.column('x'),
    y: run.column('y'),
    z: run.column('z'),
    row: run.rows,
    motion: Uint8Array.from(run.column('motion'))
  };
}

/** Returns whether any cutting move is out of a plane of x and y. */
export function hasDepth(runs: RunModel[]): boolean {
  return runs.some((run) => {
    const z = run.column('z');
    const motion = run.column('motion');
    let first = NaN;
    for (let i = 1; i < run.size; ++i) {
      if (motion[i] !== 1) continue;
      if (first !== first)
        first = z[i]!;
      else if (Math.abs(z[i]! - first) > 1e-3)
        return true;
    }
    return false;
  });
}
