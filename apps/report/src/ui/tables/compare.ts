// SPDX-License-Identifier: MIT
// Two runs side by side: time, time by limit, time by line, and the distance of their paths.
import type {Comparison} from '../../data/format.ts';
import {el, swatch, table} from '../common/dom.ts';
import {limitColour, limitName} from '../common/limits.ts';
import * as numbers from '../common/numbers.ts';
import {categoryColour} from '../common/palette.ts';
import type {Session} from '../common/session.ts';

/** Returns the panel of a comparison. */
export function comparePanel(session: Session, comparison: Comparison): HTMLElement {
  const [a, b] = comparison.time_s;
  return el(
      'div', {class: 'compare'},
      el('section', {'aria-label': 'Runs'}, named(comparison, 0), named(comparison, 1),
         el('p', {class: 'big'}, numbers.timeChange(b - a),
            el('small', {}, a ? ` ${b > a ? '+' : ''}${numbers.share((b - a) / a)} from A to B` : ''))),
      el('section', {'aria-label': 'Time by limit'}, el('h2', {}, 'Time by limit'),
         bars(comparison), byLimit(comparison)),
      paths(session, comparison), machines(comparison),
      el('section', {'aria-label': 'Difference by line'},
         el('h2', {}, 'Difference of time by line'),
         comparison.by_line.length ?
             byLine(session, comparison) :
             el('p', {class: 'empty'}, 'Every line takes the same time in both runs.')));
}

function named(comparison: Comparison, run: 0|1): HTMLElement {
  return el(
      'p', {class: 'run-name'}, swatch(categoryColour(run)), el('b', {}, run === 0 ? 'A' : 'B'),
      el('span', {title: comparison.names[run]}, withoutFolders(comparison.names[run])),
      el('span', {class: 'number'}, numbers.time(comparison.time_s[run])));
}

/** One bar for each run, as long as its time. */
function bars(comparison: Comparison): HTMLElement {
  const longest = Math.max(...comparison.time_s) || 1;
  const bar = (run: 0|1) => {
    const parts =
        el('div', {class: 'share', style: `width:${(100 * comparison.time_s[run]) / longest}%`});
    for (const {limit, a_s, b_s} of bySize(comparison)) {
      const seconds = run === 0 ? a_s : b_s;
      parts.append(el('span', {
        style: `flex:${seconds} 0 0;background:${limitColour(limit)}`,
        title: `${limitName(limit)}: ${numbers.time(seconds)}`
      }));
    }
    return el('div', {class: 'bar'}, el('b', {}, run === 0 ? 'A' : 'B'), el('div', {}, parts));
  };
  return el('div', {class: 'bars', 'aria-hidden': 'true'}, bar(0), bar(1));
}

function byLimit(comparison: Comparison): HTMLElement {
  return table(
      'Time by limit',
      [
        {
          title: 'Limit',
          cell: ({limit}) => el('span', {}, swatch(limitColour(limit)), limitName(limit))
        },
        {title: 'A', number: true, cell: ({a_s}) => numbers.time(a_s)},
        {title: 'B', number: true, cell: ({b_s}) => numbers.time(b_s)},
        {title: 'Change', number: true, cell: ({a_s, b_s}) => numbers.timeChange(b_s - a_s)},
      ],
      bySize(comparison));
}

function paths(session: Session, comparison: Comparison): HTMLElement {
  const {distance_um: distance, distance_error_um: error, distance_at: at} = comparison;
  const run = session.runs[at.run]!;
  const row = run.rowAtSeconds(at.t_s);
  const line = run.placeAt(row)?.line;
  const go = () => {
    if (session.active !== at.run) session.setActive(at.run);
    session.selectAt(row);
  };
  const link = () => el(
      'button', {type: 'button', class: 'link', onclick: go},
      `${line ? `line ${numbers.count(line)}, ` : ''}${numbers.instant(at.t_s)}`);
  return el(
      'section', {'aria-label': 'Paths'}, el('h2', {}, 'Paths'),
      el('dl', {class: 'pairs'}, el('dt', {}, 'Largest distance'),
         distance <= error ?
             el('dd', {}, `none above ${numbers.withUnit(error, 'µm')}, the accuracy of the drawing`) :
             el('dd', {}, numbers.withUnit(distance, 'µm'), ' at ', link()),
         ...contour(comparison)));
}

/** The largest contour error of each run. */
function contour({contour_um: errors}: Comparison): HTMLElement[] {
  if (!errors) return [];
  const of = (run: 0|1) => {
    const error = errors[run];
    return `${'AB'[run]} ${error === null ? '–' : numbers.withUnit(error, 'µm')}`;
  };
  return [
    el('dt', {}, 'Largest contour error'),
    el('dd', {}, el('span', {class: 'fact'}, of(0)), ' ', el('span', {class: 'fact'}, of(1)))
  ];
}

/** The values in which the machines of the runs differ. */
function machines({machine}: Comparison): HTMLElement|null {
  if (!machine?.length) return null;
  return el(
      'section', {'aria-label': 'Machine', class: 'machine'}, el('h2', {}, 'Machine'),
      table(
          'Values in which the machines differ',
          [
            {title: 'Key', cell: ({key}) => el('code', {}, broken(key))},
            {title: 'A', cell: ({a}) => a || '–'}, {title: 'B', cell: ({b}) => b || '–'}
          ],
          machine));
}

/** A key that may be broken behind its dots. */
function broken(key: string): HTMLElement {
  const text = el('span');
  for (const part of key.split(/(?<=\.)/)) text.append(part, el('wbr'));
  return text;
}

function byLine(session: Session, comparison: Comparison): HTMLElement {
  const files = session.run.data.files;
  const several = new Set(comparison.by_line.map(({file}) => file)).size > 1;
  return table(
      'Difference of time by line',
      [
        {title: 'Line', cell: ({file, line}) => `${several ? `${file}:` : ''}${line}`},
        {title: 'A', number: true, cell: ({a_s}) => numbers.time(a_s)},
        {title: 'B', number: true, cell: ({b_s}) => numbers.time(b_s)},
        {title: 'Change', number: true, cell: ({a_s, b_s}) => numbers.timeChange(b_s - a_s)},
      ],
      comparison.by_line,
      ({file, line}) =>
          session.select({file: Math.max(files.findIndex(({name}) => name === file), 0), line}));
}

/** The limits of a comparison, the one that takes longest in either run first. */
function bySize({by_limit: limits}: Comparison): Comparison['by_limit'] {
  return [...limits].sort((p, q) => Math.max(q.a_s, q.b_s) - Math.max(p.a_s, p.b_s));
}

/** The name of a run without the folders of its program. */
function withoutFolders(name: string): string {
  return name.replace(/^\S*[\\/]/, '');
}
