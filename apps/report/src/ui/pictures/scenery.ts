// SPDX-License-Identifier: MIT
// What stands beside the paths of the runs: travel, workpieces, and origins of work systems.
import type {RunModel} from '../../data/run_model.ts';
import {extentOf, travelEdges, travelOf} from '../../data/travel.ts';
import type {Origin, Outline} from '../../view/levels/path_types.ts';

const MOST_NAMES = 3;  // of systems at one place

/** An outline, the number of its run, and the file and line that state it; line 0 if none does. */
export interface RunOutline extends Outline {
  run: number;
  file: number;
  line: number;
}

/** Returns the travel of the machine of each run that has one. */
export function travelsOf(runs: RunModel[]): RunOutline[] {
  return runs.flatMap((run, index): RunOutline[] => {
    const travel = travelOf(run.data.axis_limits);
    const extent = extentOf(run);
    if (!travel || !extent) return [];
    const edges = travelEdges(travel, extent);
    return [{run: index, name: 'travel', file: 0, line: 0, look: 'travel', edges}];
  });
}

export function workpiecesOf(runs: RunModel[]): RunOutline[] {
  return runs.flatMap(
      (run, index) => (run.data.workpieces ?? [])
                          .map(({name, file, line, edges_mm: edges}): RunOutline => ({
                                 run: index,
                                 name: name || 'workpiece',
                                 file: file ?? 0,
                                 line,
                                 look: 'workpiece',
                                 edges
                               })));
}

/** Returns the outlines of the runs that are shown; one that both runs have is there once. */
export function namedOutlines(all: RunOutline[], shown: boolean[]): Outline[] {
  const same = (a: RunOutline, b: RunOutline) =>
      a.run !== b.run && a.name === b.name && a.edges.join() === b.edges.join();
  const drawn = all.filter(({run}) => shown[run]);
  const several = drawn.some(({run}) => run !== drawn[0]!.run);
  return drawn
      .filter((one, i) => !drawn.slice(0, i).some((before) => same(before, one)))
      .map((one) => {
        const common = !several || drawn.some((other) => same(other, one));
        return common ? one : {...one, name: withLetter(one.name, one.run)};
      });
}

/** Returns the origins of the runs that are shown; those at one place are one, with all names. */
export function originsOf(runs: RunModel[], shown: boolean[]): Origin[] {
  const drawn = runs.map((run, i) => (shown[i] ? run.data.origins ?? [] : []));
  const several = drawn.every(({length}) => length) && drawn.length > 1;
  const places = new Map<string, {at: Origin['at']; names: Map<string, number[]>}>();
  drawn.forEach((origins, run) => {
    for (const {name, at_mm: at} of origins) {
      const place = places.get(at.join()) ?? {at, names: new Map<string, number[]>()};
      places.set(at.join(), place);
      place.names.set(name, [...(place.names.get(name) ?? []), run]);
    }
  });
  return [...places.values()].map(({at, names}) => {
    const texts = [...names].map(
        ([name, of]) => (several && of.length === 1 ? withLetter(name, of[0]!) : name));
    const rest = texts.length - MOST_NAMES;
    return {at, name: texts.slice(0, MOST_NAMES).join(', ') + (rest > 0 ? ` +${rest}` : '')};
  });
}

const withLetter = (name: string, run: number): string => `${name} ${'AB'[run]}`;
