// SPDX-License-Identifier: MIT
// How a run has ended, in words.
import type {RunData} from '../../data/format.ts';
import {plural} from './numbers.ts';

const TEXTS = {
  done: 'done',
  stopped: 'stopped before its end',
  alarm: 'ended by an alarm'
};

/** Returns the end of a run; the number of errors for a program that has some. */
export function statusText({status, diagnostics, setpoints}: RunData): string {
  if (status !== 'error') return TEXTS[status];
  const errors = diagnostics.filter(({severity}) => severity === 'error').length;
  const how = setpoints > 0 ? 'not run to its end' : 'not run';
  return errors ? `${how}: ${plural(errors, 'error')}` : how;
}
