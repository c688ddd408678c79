// SPDX-License-Identifier: MIT
// Which charts there are, and the series of each.
import type {Between} from '../../data/decimation.ts';
import type {NodeColumn} from '../../data/format.ts';
import type {RunModel} from '../../data/run_model.ts';

export interface Series {
  label: string;
  column: NodeColumn;
  between: Between;
  factor: number;
  light: string;
  dark: string;
  dash?: number[];
  lowest?: number;  // values below mean that there is none
}

export interface ChartSpec {
  id: string;
  title: string;
  unit: string;
  series: Series[];
  strip?: boolean;  // has the limits under it
  fromZero: boolean;
  least?: number;  // that the axis reaches at least
}

const BLUE = {
  light: '#0067a5',
  dark: '#56b4e9'
};
const ORANGE = {
  light: '#b85000',
  dark: '#e69f00'
};
const GREEN = {
  light: '#007a59',
  dark: '#2cc295'
};
const GREY = {
  light: '#6b7280',
  dark: '#a3abb5'
};
const PURPLE = {
  light: '#a34d80',
  dark: '#cc79a7'
};

const uses = (label: string, column: NodeColumn, colours: {light: string; dark: string}): Series =>
    ({label, column, between: 'interval', factor: 100, ...colours});
const error = (label: string, column: NodeColumn, colours: {light: string; dark: string}): Series =>
    ({label, column, between: 'interval', factor: 1, lowest: 0, ...colours});
const position =
    (label: string, column: NodeColumn, colours: {light: string; dark: string}): Series =>
        ({label, column, between: 'linear', factor: 1, ...colours});

const CHARTS: ChartSpec[] = [
  {
    id: 'feed',
    title: 'Feed',
    unit: 'mm/min',
    strip: true,
    fromZero: true,
    series: [
      {
        label: 'programmed',
        column: 'feed',
        between: 'interval',
        factor: 60,
        lowest: 1e-9,
        dash: [4, 3],
        ...GREY
      },
      {label: 'achieved', column: 'v', between: 'linear', factor: 60, ...BLUE}
    ]
  },
  {
    id: 'use',
    title: 'Use of limits',
    unit: '%',
    fromZero: true,
    least: 100,
    series: [uses('acceleration', 'acceleration_use', ORANGE), uses('jerk', 'jerk_use', PURPLE)]
  },
  {
    id: 'contour',
    title: 'Contour error',
    unit: 'µm',
    fromZero: true,
    series: [error('contour error', 'contour_um', ORANGE)]
  },
  {
    id: 'errors',
    title: 'Path errors',
    unit: 'µm',
    fromZero: true,
    series:
        [error('chord error', 'chord_error_um', BLUE), error('deviation', 'deviation_um', PURPLE)]
  },
  {
    id: 'rmax',
    title: 'Predicted Rmax',
    unit: 'µm',
    fromZero: true,
    series: [
      {...error('target', 'rmax_target_um', GREY), dash: [4, 3]}, error('Rmax', 'rmax_um', GREEN)
    ]
  },
  {
    id: 'position',
    title: 'Position',
    unit: 'mm',
    fromZero: false,
    series: [position('X', 'x', BLUE), position('Y', 'y', ORANGE), position('Z', 'z', GREEN)]
  },
];

/** Returns the charts for which the runs have data, each with the series that any of them has. */
export function chartsOf(runs: RunModel[]): ChartSpec[] {
  return CHARTS
      .map((chart) => ({
             ...chart,
             series: chart.series.filter(({column}) => runs.some((run) => run.has(column)))
           }))
      .filter(({series}) => series.length > 0);
}
