// SPDX-License-Identifier: MIT
// What is printed: the first screen, a picture of the path, and the tables.
import {el, fill} from '../common/dom.ts';
import type {Session} from '../common/session.ts';
import type {PathPanel} from '../pictures/path_panel.ts';
import {surfaceNumbers} from '../pictures/surface_panel.ts';
import type {Messages} from '../program/messages.ts';
import {comparePanel} from '../tables/compare.ts';
import {details} from '../tables/details.ts';
import type {Summary} from '../tables/summary.ts';
import {whatIfPanel} from '../tables/what_if.ts';

/** Panels that are printed as they are. */
export interface Printed {
  session: Session;
  path: PathPanel;
  summary: Summary;
  messages: Messages;
}

/** Prepares `sheet` for printing; in light colours whatever the page has. */
export function prepareSheet(
    {session, path, summary, messages}: Printed, sheet: HTMLElement): void {
  const {report, run, dark} = session;
  const {surface} = session.runs[0]!.data;
  if (dark) session.setDark(false);
  path.colour();
  const picture = path.view?.toImage();
  const legend = path.element.querySelector('.legend')?.cloneNode(true);
  if (dark) session.setDark(true);
  fill(
      sheet,
      el('h1', {}, run.data.program.split(/[\\/]/).pop() ?? '',
         el('small', {}, run.data.machine ? ` on ${run.data.machine}` : '')),
      el('div', {class: 'sheet-first'}, shown(summary.element),
         picture ?
             el('figure', {}, el('img', {src: picture, alt: 'The path'}), legend as HTMLElement) :
             null),
      report.comparison ? comparePanel(session, report.comparison) : null,
      report.what_if ? whatIfPanel(report.what_if) : null,
      run.data.diagnostics.length ? shown(messages.element) : null,
      surface ? surfaceNumbers(session, surface) : null, details(run.data, report.softcnc));
}

/** A copy of a panel, which may be hidden. */
function shown(panel: HTMLElement): HTMLElement {
  const copy = panel.cloneNode(true) as HTMLElement;
  copy.hidden = false;
  for (const name of ['id', 'role', 'aria-labelledby']) copy.removeAttribute(name);
  return copy;
}
