// SPDX-License-Identifier: MIT
// The texts along the axes of charts.
import * as numbers from '../common/numbers.ts';

const LONG = 300;  // s, from which times are minutes and seconds
const CLOCK_STEPS = [10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18000, 36000];  // s

/** Returns the steps that an axis of time may have, or undefined for decimal ones. */
export function timeSteps(seconds: number): number[]|undefined {
  return seconds > LONG ? CLOCK_STEPS : undefined;
}

/** Seconds, or minutes and seconds where there are many; the first tick has the unit. */
export function timeTexts(ticks: number[]): string[] {
  const clock = (ticks[ticks.length - 1] ?? 0) > LONG;
  const text = (value: number) => (clock ? clockText(value, ticks) : axisText(value, ticks));
  return ticks.map((value, i) => text(value) + (i === 0 ? (clock ? ' min' : ' s') : ''));
}

/** Lengths in mm; the first tick has the unit. */
export function lengthTexts(ticks: number[]): string[] {
  return ticks.map((value, i) => axisText(value, ticks) + (i === 0 ? ' mm' : ''));
}

function clockText(value: number, ticks: number[]): string {
  const decimals = decimalsOf(ticks);
  const units = Math.round(value * 10 ** decimals);
  const seconds = (units % (60 * 10 ** decimals)) / 10 ** decimals;
  const minutes = Math.floor(units / (60 * 10 ** decimals));
  return `${minutes}:${seconds.toFixed(decimals).padStart(decimals ? decimals + 3 : 2, '0')}`;
}

/** A tick with as many decimals as its neighbours need. */
export function axisText(value: number, ticks: number[]): string {
  return numbers.fixed(value, decimalsOf(ticks));
}

function decimalsOf(ticks: number[]): number {
  const step = ticks.length > 1 ? ticks[1]! - ticks[0]! : ticks[0] || 1;
  let decimals = 0;
  while (decimals < 9 && Math.abs(step * 10 ** decimals - Math.round(step * 10 ** decimals)) > 1e-6)
    ++decimals;
  return decimals;
}

/** A value with three digits, or without decimals. */
export function axisFree(value: number): string {
  return Math.abs(value) >= 1000 ? numbers.count(value) : numbers.plain(value, 3);
}
