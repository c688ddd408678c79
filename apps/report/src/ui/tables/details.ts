// SPDX-License-Identifier: MIT
// Tables of a run: its figures, tools, limits of the machine, and how exact the report is.
import type {RunData} from '../../data/format.ts';
import {el, table, type Child} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';
import type {Session} from '../common/session.ts';

const SOURCES = {
  program: 'a program, planned for this report',
  trace: 'a trace',
  recording: 'a recording'
};

/** Returns the tables of a run. */
export function details(data: RunData, softcnc: string): HTMLElement {
  return el(
      'div', {class: 'details'}, section('Run', pairs(runFacts(data, softcnc))),
      data.figures.length > 0 &&
          section(
              'Figures',
              pairs(data.figures.map(
                  ({name, value, unit}) => [name, numbers.withUnit(value, unit, 4)]))),
      data.tools.length > 0 && section('Time by tool', tools(data)),
      data.axis_limits.length > 0 && section('Limits of the axes', limits(data)));
}

/** The panel of the tables, which follows the run that is shown. */
export function detailsPanel(session: Session): HTMLElement {
  const panel = el('div');
  const draw = () => panel.replaceChildren(details(session.run.data, session.report.softcnc));
  session.on(['run'], draw);
  draw();
  return panel;
}

function section(title: string, content: Child): HTMLElement {
  return el('section', {'aria-label': title}, el('h2', {}, title), content);
}

function pairs(rows: Array<[string, string]>): HTMLElement {
  const list = el('dl', {class: 'pairs'});
  for (const [name, value] of rows) list.append(el('dt', {}, name), el('dd', {}, value));
  return list;
}

function runFacts(data: RunData, softcnc: string): Array<[string, string]> {
  const rows: Array<[string, string | undefined]> = [
    ['program', data.program],
    ['made from', SOURCES[data.source]],
    ['machine', data.machine || undefined],
    ['machine file', data.machine_file],
    ['method', data.method],
    ['status', data.status],
    ['time', numbers.time(data.time_s)],
    ['path', numbers.length(data.length_mm)],
    ['blocks', data.blocks ? numbers.count(data.blocks) : undefined],
    [
      'rows',
      data.setpoints ?
          `${numbers.count(data.setpoints)}, one every ${numbers.plain(data.period_s * 1e3)} ms` :
          undefined
    ],
    [
      'rests at corners',
      data.rests ? `${numbers.count(data.rests.count)}, ${numbers.time(data.rests.seconds)}` :
                   undefined
    ],
    [
      'accuracy of the drawing',
      data.nodes.row?.count ? `within ${numbers.plain(data.error_um)} µm and ${
                                  numbers.plain(60 * data.error_mm_s)} mm/min of every row` :
                              undefined
    ],
    ['softcnc', softcnc],
  ];
  return rows.filter((row): row is[string, string] => row[1] !== undefined);
}

function tools(data: RunData): HTMLElement {
  return table(
      'Time by tool',
      [
        {title: 'Tool', cell: ({tool}) => `T${tool}`},
        {title: 'Cutting', number: true, cell: ({cutting_s}) => numbers.time(cutting_s)},
        {title: 'Rapid', number: true, cell: ({rapid_s}) => numbers.time(rapid_s)},
        {title: 'Dwell', number: true, cell: ({dwell_s}) => numbers.time(dwell_s)},
        {title: 'Rest', number: true, cell: ({rest_s}) => numbers.time(rest_s)},
      ],
      data.tools);
}

function limits(data: RunData): HTMLElement {
  const ranged = data.axis_limits.some(({min_mm}) => typeof min_mm === 'number');
  return table(
      'Limits of the axes',
      [
        {title: 'Axis', cell: ({axis}) => axis.toUpperCase()},
        {
          title: 'Velocity, mm/s',
          number: true,
          cell: ({velocity_mm_s}) => numbers.plain(velocity_mm_s)
        },
        {
          title: 'Acceleration, mm/s²',
          number: true,
          cell: ({acceleration_mm_s2}) => numbers.plain(acceleration_mm_s2)
        },
        {
          title: 'Jerk, mm/s³',
          number: true,
          cell: ({jerk_mm_s3}) => (jerk_mm_s3 ? numbers.plain(jerk_mm_s3) : 'none')
        },
        ...(ranged ? [{
          title: 'Range, mm',
          number: true,
          cell: ({min_mm, max_mm}: RunData['axis_limits'][number]) => typeof min_mm !== 'number' ?
              '–' :
              `${numbers.plain(min_mm)} to ${numbers.plain(max_mm ?? NaN)}`
        }] :
                     []),
      ],
      data.axis_limits);
}
