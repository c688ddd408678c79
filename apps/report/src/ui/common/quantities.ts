// SPDX-License-Identifier: MIT
// What the path can be coloured by, and the colours of a run's nodes.
import type {NodeColumn} from '../../data/format.ts';
import type {RunModel} from '../../data/run_model.ts';
import {limitColour, limitName} from './limits.ts';
import {categoryColour, neutral, rgbOf, salienceTable, type Rgb} from './palette.ts';

export type QuantityId =|'ratio'|'speed'|'limit'|'acceleration'|'jerk'|'contour'|'deviation'|
    'chord'|'rmax'|'tool'|'run';

export interface Quantity {
  id: QuantityId;
  label: string;
  unit: string;
  column?: NodeColumn;  // that must be there
  factor: number;       // from the column's unit to `unit`
}

/** All quantities, in the order of the menu. */
export const QUANTITIES: Quantity[] = [
  {id: 'ratio', label: 'Achieved / programmed feed', unit: '%', factor: 100},
  {id: 'speed', label: 'Speed', unit: 'mm/min', column: 'v', factor: 60},
  {id: 'limit', label: 'Limit', unit: '', column: 'limit', factor: 1},
  {
    id: 'acceleration',
    label: 'Use of acceleration',
    unit: '%',
    column: 'acceleration_use',
    factor: 100
  },
  {id: 'jerk', label: 'Use of jerk', unit: '%', column: 'jerk_use', factor: 100},
  {id: 'contour', label: 'Contour error', unit: 'µm', column: 'contour_um', factor: 1},
  {
    id: 'deviation',
    label: 'Deviation from the program',
    unit: 'µm',
    column: 'deviation_um',
    factor: 1
  },
  {id: 'chord', label: 'Chord error', unit: 'µm', column: 'chord_error_um', factor: 1},
  {id: 'rmax', label: 'Predicted Rmax', unit: 'µm', column: 'rmax_um', factor: 1},
  {id: 'tool', label: 'Tool', unit: '', column: 'tool', factor: 1},
  {id: 'run', label: 'Run', unit: '', factor: 1},
];

/** Returns the quantities for which at least one run has data. */
export function quantitiesOf(runs: RunModel[]): Quantity[] {
  return QUANTITIES.filter(
      (quantity) => quantity.id === 'run' ? runs.length > 1 :
          quantity.id === 'tool'          ? toolsOf(runs).length > 1 :
                                            !quantity.column ||
              runs.some((run) => run.has(quantity.column!)));
}

/** Returns the numbers of the tools of all runs, ascending. */
export function toolsOf(runs: RunModel[]): number[] {
  const tools = new Set<number>();
  for (const run of runs)
    for (const {tool} of run.data.tools) tools.add(tool);
  return [...tools].sort((a, b) => a - b);
}

export function isCategory(id: QuantityId): boolean {
  return id === 'limit' || id === 'tool' || id === 'run';
}

/** Returns the value of every interval in the unit of the quantity, NaN where it has none. */
export function intervalValues(run: RunModel, quantity: Quantity): Float32Array {
  if (quantity.id === 'ratio') return ratios(run);
  const values = new Float32Array(run.size).fill(NaN);
  if (!quantity.column || !run.has(quantity.column)) return values;
  const column = run.column(quantity.column);
  const motion = run.column('motion');
  const all = quantity.id === 'speed' || quantity.id === 'acceleration' || quantity.id === 'jerk';
  for (let i = 1; i < values.length; ++i) {
    if (!(all || motion[i] === 1) || column[i]! < 0) continue;
    const value = quantity.id === 'speed' ? (column[i - 1]! + column[i]!) / 2 : column[i]!;
    values[i] = value * quantity.factor;
  }
  return values;
}

function ratios(run: RunModel): Float32Array {
  const values = new Float32Array(run.size).fill(NaN);
  const v = run.column('v');
  const feed = run.column('feed');
  const motion = run.column('motion');
  for (let i = 1; i < values.length; ++i)
    if (motion[i] === 1 && feed[i]! > 0)
      values[i] = Math.min((50 * (v[i - 1]! + v[i]!)) / feed[i]!, 100);
  return values;
}

/** Returns the ends of the scale of a quantity over all runs: 0 and its largest value. */
export function scaleOf(runs: RunModel[], quantity: Quantity): [number, number] {
  if (quantity.id === 'ratio') return [0, 100];
  let most = 0;
  for (const run of runs)
    for (const value of intervalValues(run, quantity))
      if (value > most) most = value;
  if (quantity.id === 'acceleration' || quantity.id === 'jerk') most = Math.max(most, 100);
  return [0, most || 1];
}

/**
 * Returns the colour of the interval of a run that ends in each node, three bytes each. The same
 * value has the same colour in all runs.
 */
export function coloursOf(
    runs: RunModel[], index: number, quantity: Quantity, scale: [number, number],
    dark: boolean): Uint8Array {
  const run = runs[index]!;
  if (isCategory(quantity.id)) return categoryColours(runs, index, quantity);
  const values = intervalValues(run, quantity);
  const table = salienceTable(dark);
  const none = neutral(dark);
  const rgb = new Uint8Array(3 * values.length);
  const [low, high] = quantity.id === 'ratio' ? [scale[1], scale[0]] : scale;  // slow is remarkable
  for (let i = 0; i < values.length; ++i) {
    const part = (values[i]! - low) / (high - low);
    const at = 3 * Math.round(255 * Math.min(Math.max(part, 0), 1));
    const known = part === part;
    rgb[3 * i] = known ? table[at]! : none[0];
    rgb[3 * i + 1] = known ? table[at + 1]! : none[1];
    rgb[3 * i + 2] = known ? table[at + 2]! : none[2];
  }
  return rgb;
}

function categoryColours(runs: RunModel[], index: number, quantity: Quantity): Uint8Array {
  const run = runs[index]!;
  const rgb = new Uint8Array(3 * run.size);
  const column =
      quantity.id === 'run' ? null : run.column(quantity.id === 'limit' ? 'limit' : 'tool');
  const tools = toolsOf(runs);
  const known = new Map<number, Rgb>();
  const colourOf = (value: number) => rgbOf(
      quantity.id === 'limit' ?
          limitColour(run.data.limits[value] ?? '') :
          categoryColour(quantity.id === 'tool' ? Math.max(tools.indexOf(value), 0) : index));
  for (let i = 0; i < run.size; ++i) {
    const value = column ? column[i]! : 0;
    let colour = known.get(value);
    if (!colour) known.set(value, (colour = colourOf(value)));
    rgb.set(colour, 3 * i);
  }
  return rgb;
}

/** Returns the categories of a quantity with their colours, as far as the runs have them. */
export function categoriesOf(
    runs: RunModel[], id: QuantityId): Array<{name: string; colour: string}> {
  if (id === 'run')
    return runs.map(
        (_, i) => ({name: i === 0 ? 'A (before)' : 'B (after)', colour: categoryColour(i)}));
  if (id === 'tool')
    return toolsOf(runs).map((tool, i) => ({name: `T${tool}`, colour: categoryColour(i)}));
  const limits = new Set(runs.flatMap((run) => run.data.time_by_limit_s.map(({limit}) => limit)));
  limits.delete('rapid');  // the view draws rapids apart
  return [...limits].map((limit) => ({name: limitName(limit), colour: limitColour(limit)}));
}
