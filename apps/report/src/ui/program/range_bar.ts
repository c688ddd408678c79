// SPDX-License-Identifier: MIT
// The range of lines that is shown alone: from where to where, and what it takes.
import type {LineRange} from '../../data/run_model.ts';
import {el, fill} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';
import type {Session} from '../common/session.ts';

export class RangeBar {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly file: () => number;
  private readonly first = this.input('First line that is shown', 'from');
  private readonly last = this.input('Last line that is shown', 'to');
  private readonly rest = el('span', {class: 'found-range', role: 'status'});

  /** `file` is the file whose lines are meant. */
  constructor(session: Session, file: () => number) {
    this.session = session;
    this.file = file;
    this.element =
        el('div', {class: 'tools', role: 'group', 'aria-label': 'Range of lines'},
           el('span', {class: 'facts'}, 'Lines'), this.first, '–', this.last, this.rest);
    session.on(['lines', 'run'], () => this.draw());
  }

  private input(label: string, placeholder: string): HTMLInputElement {
    return el('input', {
      type: 'text',
      inputMode: 'numeric',
      placeholder,
      'aria-label': label,
      title: `${label}; or Shift and click on a line`,
      onchange: () => this.apply(),
      onkeydown: (event: KeyboardEvent) => event.key === 'Escape' && this.session.setLines(null)
    });
  }

  private apply(): void {
    const {session} = this;
    const [first, last] =
        [this.first, this.last].map(({value}) => (/^\s*\d+\s*$/.test(value) ? Number(value) : 0));
    if (!first || !last) return;
    const file = this.file();
    const count = session.run.lineCount(file);
    session.setLines({file, first: Math.min(first, count), last: Math.min(last, count)});
  }

  private draw(): void {
    const {session} = this;
    const {lines} = session;
    this.first.value = lines ? String(lines.first) : '';
    this.last.value = lines ? String(lines.last) : '';
    fill(
        this.rest, lines && el('span', {}, this.readout(lines)),
        lines &&
            el('button', {
              type: 'button',
              title: 'Show all lines again (Esc)',
              onclick: () => session.setLines(null)
            },
               'All'));
  }

  private readout(lines: LineRange): string {
    const {run, stays, active} = this.session;
    const own = stays[active] ?? [];
    if (!own.length) return 'no motion';
    const {seconds, lost} = run.timeOfLines(lines);
    const mm = run.has('s') ? `, ${numbers.length(run.lengthOf(own))}` : '';
    return `${numbers.time(seconds)}, ${numbers.time(lost)} lost${mm}`;
  }
}
