// SPDX-License-Identifier: MIT
// What faster axes would win.
import type {WhatIf} from '../../data/format.ts';
import {el, table} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';

const LIMITS = {
  velocity: 'velocity',
  acceleration: 'acceleration',
  jerk: 'jerk'
};

/** Returns the table of a what-if: one row for each limit that was raised. */
export function whatIfPanel(whatIf: WhatIf): HTMLElement {
  const most = Math.max(...whatIf.rows.map(({won_s}) => won_s), 0);
  return el(
      'div', {class: 'what-if'}, el('h2', {}, 'What a faster axis would win'),
      el('p', {class: 'facts'},
         `The run takes ${
             numbers.time(
                 whatIf.time_s)}. Each row is a run that was planned with this one limit raised.`),
      table(
          'What if a limit were higher',
          [
            {title: 'Axis', cell: ({axis}) => axis.toUpperCase()},
            {
              title: 'Limit',
              cell: ({limit, factor}) =>
                  `${LIMITS[limit]} +${numbers.fixed(100 * (factor - 1), 0)} %`
            },
            {title: 'Time', number: true, cell: ({time_s}) => numbers.time(time_s)},
            {title: 'Won', number: true, cell: ({won_s}) => numbers.time(won_s)},
            {
              title: 'Share',
              number: true,
              cell: ({won_s}) =>
                  el('span', {
                    class: 'meter',
                    style: `--part:${most > 0 ? Math.max((100 * won_s) / most, 0) : 0}%`
                  },
                     whatIf.time_s ? numbers.share(won_s / whatIf.time_s) : '–')
            },
          ],
          whatIf.rows));
}
