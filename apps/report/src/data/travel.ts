// SPDX-License-Identifier: MIT
// The travel of a machine: how far its axes go, and whether a run leaves that.
import type {Axis, AxisLimit} from './format.ts';
import type {RunModel} from './run_model.ts';

const AXES: Axis[] = ['x', 'y', 'z'];
const ROUNDING_MM = 1e-6;

/** The ends of an axis in mm; null where it has none. */
export type Ends = [number|null, number|null];

/** The ends of x, y and z. */
export type Travel = [Ends, Ends, Ends];

/** Lowest and highest position of each axis, in mm. */
export type Extent = [[number, number], [number, number], [number, number]];

/** Returns the travel, or null where fewer than two axes have an end: that bounds nothing. */
export function travelOf(limits: AxisLimit[]): Travel|null {
  const travel = AXES.map((axis): Ends => {
    const limit = limits.find((one) => one.axis === axis);
    return [limit?.min_mm ?? null, limit?.max_mm ?? null];
  }) as Travel;
  return travel.filter(hasEnd).length < 2 ? null : travel;
}

/** Returns how far the nodes of a run go; null for a run without nodes. */
export function extentOf(run: RunModel): Extent|null {
  if (!run.size) return null;
  return AXES.map((axis) => {
    let low = Infinity;
    let high = -Infinity;
    for (const value of run.column(axis)) {
      if (value < low) low = value;
      if (value > high) high = value;
    }
    return [low, high];
  }) as Extent;
}

/** Returns whether a run is out of its travel somewhere, by more than its nodes may be off. */
export function leavesTravel(run: RunModel): boolean {
  const travel = travelOf(run.data.axis_limits);
  const extent = extentOf(run);
  if (!travel || !extent) return false;
  const slack = run.data.error_um / 1e3 + ROUNDING_MM;
  return travel.some(
      ([min, max], axis) => extent[axis]![0] < (min ?? -Infinity) - slack ||
          extent[axis]![1] > (max ?? Infinity) + slack);
}

/**
 * Returns the edges of the sides that the travel has, six numbers each. Where an axis lacks one end
 * its edges go as far as `extent`, and are open; where it lacks both, the others are drawn at the
 * lower end of `extent`.
 */
export function travelEdges(travel: Travel, extent: Extent): number[] {
  const edges: number[] = [];
  const ends = travel.map((axis, k) => drawnEnds(axis, extent[k]!));
  for (let along = 0; along < 3; ++along) {
    const [a, b] = [(along + 1) % 3, (along + 2) % 3] as [number, number];
    const [from, to] = ends[along]!.span;
    if (from === to) continue;
    for (const p of ends[a]!.sides)
      for (const q of ends[b]!.sides) {
        const point = (at: number) =>
            [0, 1, 2].map((axis) => (axis === along ? at : axis === a ? p : q));
        edges.push(...point(from), ...point(to));
      }
  }
  return edges;
}

const hasEnd = ([min, max]: Ends): boolean => min !== null || max !== null;

/** Where the sides of an axis are, and from where to where edges along it go. */
function drawnEnds([min, max]: Ends, [low, high]: [number, number]):
    {sides: number[]; span: [number, number]} {
  if (min === null && max === null) return {sides: [low], span: [low, low]};
  const sides = [min, max].filter((end): end is number => end !== null);
  return {sides, span: [min ?? Math.min(low, max!), max ?? Math.max(high, min!)]};
}
