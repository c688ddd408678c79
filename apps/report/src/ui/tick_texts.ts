// SPDX-License-Identifier: MIT
// The texts along the axes of charts.
import * as numbers from './numbers.ts';

const LONG = 300;  // s, from which times are minutes and seconds
const CLOCK_STEPS = [10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18000, 36000];  // s

/** Returns the steps that an axis of time may have, or undefined for decimal ones. */
export function timeSteps(seconds: number): number[]|undefined {
  return seconds > LONG ? CLOCK_STEPS : undefined;
}

/** Seconds, or minutes and seconds where the steps are longer; the last tick has the unit. */
export function timeTexts(ticks: number[]): string[] {
  const last = ticks[ticks.length - 1] ?? 0;
  const clock = ticks.length > 1 && ticks[1]! - ticks[0]! >= CLOCK_STEPS[0]! && last > LONG;
  const text = (value: number) => clock ?
      `${Math.floor(value / 60)}:${String(Math.round(value % 60)).padStart(2, '0')}` :
      axisText(value, ticks);
  return ticks.map(
      (value, i) => text(value) + (i === ticks.length - 1 ? (clock ? ' min' : ' s') : ''));
}

/** Lengths in mm; the last tick has the unit. */
export function lengthTexts(ticks: number[]): string[] {
  return ticks.map((value, i) => axisText(value, ticks) + (i === ticks.length - 1 ? ' mm' : ''));
}

/** A tick with as many decimals as its neighbours need. */
export function axisText(value: number, ticks: number[]): string {
  const step = ticks.length > 1 ? Math.abs(ticks[1]! - ticks[0]!) : Math.abs(value) || 1;
  return numbers.fixed(value, Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
}

/** A value with three digits, or without decimals. */
export function axisFree(value: number): string {
  return Math.abs(value) >= 1000 ? numbers.count(value) : numbers.plain(value, 3);
}
