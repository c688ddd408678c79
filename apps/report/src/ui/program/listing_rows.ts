// SPDX-License-Identifier: MIT
// The elements of a line of the program, and of a diagnostic below it.
import type {Diagnostic} from '../../data/format.ts';
import type {LineTime} from '../../data/run_model.ts';
import {el} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';
import {underline} from './messages.ts';

const LONGEST = 2000;  // characters of a line that are shown

/** A line as it is shown. */
export interface ShownLine {
  line: number;
  text: string;
  time: LineTime|null;  // null where the line does not move
  longest: number;      // time of the slowest line, in s
  selected: boolean;
  within: boolean;    // is one of those that are shown alone
  remarked: boolean;  // has a diagnostic below it
  now: boolean;       // the tool is on it
}

/** Returns the element of a line: its number, its time and its text. */
export function lineRow({line, text, time, longest, selected, within, remarked, now}: ShownLine):
    HTMLElement {
  const part = time && longest ? time.seconds / longest : 0;
  const classes = [
    'line', selected && 'selected', within && 'within', !time && 'still', remarked && 'remarked', now && 'now'
  ].filter(Boolean);
  return el(
      'div', {
        class: classes.join(' '),
        'data-line': line,
        id: `line-${line}`,
        role: 'option',
        'aria-selected': String(selected || within)
      },
      el('span', {class: 'n'}, String(line)),
      el('span', {
        class: 't',
        style: `--part:${(100 * part).toFixed(1)}%`,
        title: time ?
            `${numbers.time(time.seconds)}, ${numbers.time(time.lost)} lost against the feed` :
            ''
      },
         time ? numbers.lineTime(time.seconds) : ''),
      el('code', {}, shownText(text)));
}

/** Returns the elements of a diagnostic: the mark below its place, and its text. */
export function noteRows(diagnostic: Diagnostic): HTMLElement[] {
  const {column, severity, code, message, help} = diagnostic;
  const indent = ' '.repeat(Math.max(column - 1, 0));
  const full = `${severity}: ${message} [${code}]${help ? `\n${help}` : ''}`;
  const mark = column > 0 ? indent + underline(diagnostic) : '';
  return [
    el('div', {class: `remark ${severity}`, role: 'presentation'}, el('span', {class: 'n'}),
       el('span', {class: 't'}), el('code', {}, mark)),
    el('div', {class: `remark message ${severity}`, role: 'note', title: full},
       `${severity}: ${message} [${code}]`)
  ];
}

function shownText(text: string): string {
  const whole = text.replace(/\t/g, ' ') || ' ';
  return whole.length > LONGEST ? `${whole.slice(0, LONGEST)}…` : whole;
}
