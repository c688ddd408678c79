// SPDX-License-Identifier: MIT
// The axes of a chart: time or length from left to right, and the values at the left.
import type uPlot from 'uplot';
import type {ChartAxis} from '../common/session.ts';
import {axisText, lengthTexts, timeSteps, timeTexts} from './tick_texts.ts';

/** Width of the axis of the values, in px. */
export const LEFT = 58;

const FONT = '11px system-ui, sans-serif';

/** Returns the axes; `span` is the time or length that is shown, `strips` the px under the plot. */
export function chartAxes(
    axis: ChartAxis, span: number, strips: number, dark: boolean): uPlot.Axis[] {
  const look = {
    stroke: dark ? '#a6aeb8' : '#545c66',
    font: FONT,
    ticks: {show: false},
    grid: {stroke: dark ? '#2b3038' : '#e8ebef', width: 1},
  };
  return [
    {
      ...look,
      size: 22 + strips,
      gap: (strips ? 2 : 4) + strips,
      space: 70,
      incrs: axis === 'time' ? timeSteps(span) : undefined,
      values: (_, ticks) => (axis === 'time' ? timeTexts(ticks) : lengthTexts(ticks))
    },
    {
      ...look,
      size: LEFT,
      gap: 4,
      space: 24,
      values: (_, ticks) => ticks.map((value) => axisText(value, ticks))
    }
  ];
}
