// SPDX-License-Identifier: MIT
// What is printed: the first screen, a picture of the path, and the tables.
import { comparePanel } from './compare.ts';
import { details } from './details.ts';
import { el, fill } from './dom.ts';
import type { PathPanel } from './path_panel.ts';
import type { Session } from './session.ts';
import { Messages } from './messages.ts';
import { Summary } from './summary.ts';
import { whatIfPanel } from './what_if.ts';

/** Prepares `sheet` for printing; in light colours whatever the page has. */
export function prepareSheet(session: Session, path: PathPanel, sheet: HTMLElement): void {
  const { report, run, dark } = session;
  if (dark) session.setDark(false);
  const picture = path.view?.toImage();
  const legend = path.element.querySelector('.legend')?.cloneNode(true);
  if (dark) session.setDark(true);
  fill(sheet,
    el('h1', {}, run.data.program, el('small', {}, ` on ${run.data.machine}`)),
    el('div', { class: 'sheet-first' }, new Summary(session).element,
      picture ? el('figure', {}, el('img', { src: picture, alt: 'The path' }), legend as HTMLElement) : null),
    report.comparison ? comparePanel(session, report.comparison) : null,
    report.what_if ? whatIfPanel(report.what_if) : null,
    run.data.diagnostics.length ? new Messages(session).element : null,
    details(run.data, report.softcnc));
}
