// SPDX-License-Identifier: MIT
// What the picture of the paths takes from the runs.
import type {RowRange, RunModel} from '../../data/run_model.ts';
import type {PathLayer} from '../../view/path/path_view.ts';

const MOST_ENDS = 100000;  // of stretches that get nodes of their own

/** The path of a run as it is drawn. */
export interface DrawnPath {
  layer: PathLayer;
  nodes: Uint32Array|null;  // the node of the run for each of the layer; null if they are the same
}

/** Returns the path of a run, with nodes of its own at the ends of these stretches. */
export function drawnPath(run: RunModel, stretches: RowRange[]): DrawnPath {
  const layer = layerOf(run);
  if (!stretches.length || 2 * stretches.length > MOST_ENDS) return {layer, nodes: null};
  const ends = stretches.flatMap(({from, to}) => [from, to]);
  const rows: number[] = [];
  const nodes: number[] = [];
  let next = 0;
  for (let node = 0; node < run.size; ++node) {
    const row = run.rows[node]!;
    for (; next < ends.length && ends[next]! <= row; ++next) {
      if (node === 0 || ends[next] === row || ends[next] === rows[rows.length - 1]) continue;
      rows.push(ends[next]!);
      nodes.push(node);
    }
    rows.push(row);
    nodes.push(node);
  }
  const all = Uint32Array.from(nodes);
  return {layer: between(run, layer, Float64Array.from(rows), all), nodes: all};
}

/** Returns values of a run's nodes, `size` for each, as values of the nodes that are drawn. */
export function spread({nodes}: DrawnPath, values: Uint8Array, size: number): Uint8Array {
  if (!nodes) return values;
  const all = new Uint8Array(nodes.length * size);
  for (let i = 0; i < nodes.length; ++i)
    for (let k = 0; k < size; ++k) all[i * size + k] = values[nodes[i]! * size + k]!;
  return all;
}

function layerOf(run: RunModel): PathLayer {
  return {
    x: run.column('x'),
    y: run.column('y'),
    z: run.column('z'),
    row: run.rows,
    motion: Uint8Array.from(run.column('motion'))
  };
}

/** Interpolates a path at rows, of which each is in the interval of its node. */
function between(
    run: RunModel, layer: PathLayer, row: Float64Array, nodes: Uint32Array): PathLayer {
  const along = (axis: 'x'|'y'|'z') => Float64Array.from(row, (at, i) => {
    const node = nodes[i]!;
    return run.rows[node] === at ? layer[axis][node]! : run.valueAt(axis, at);
  });
  const motion = Uint8Array.from(nodes, (node) => layer.motion[node]!);
  return {x: along('x'), y: along('y'), z: along('z'), row, motion};
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
