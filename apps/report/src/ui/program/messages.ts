// SPDX-License-Identifier: MIT
// All diagnostics of a run, each with its place, its line and a caret.
import type {Diagnostic} from '../../data/format.ts';
import {el, fill} from '../common/dom.ts';
import {plural} from '../common/numbers.ts';
import type {Session} from '../common/session.ts';

const MOST = 300;        // that are shown at once
const MOST_MARKED = 80;  // characters
const SIGNS = {
  error: '✕',
  warning: '▲',
  note: '●'
};

export class Messages {
  readonly element = el('div', {class: 'messages'});
  private readonly session: Session;
  private at = -1;
  private shown = MOST;

  constructor(session: Session) {
    this.session = session;
    session.on(['run'], () => this.restart());
    this.draw();
  }

  /** Goes to the next or the previous diagnostic that has a line. */
  step(by: 1|- 1): void {
    const {diagnostics} = this.session.run.data;
    if (!diagnostics.length) return;
    this.at = (Math.max(this.at, by > 0 ? -1 : 0) + by + diagnostics.length) % diagnostics.length;
    this.go(diagnostics[this.at]!);
  }

  private restart(): void {
    this.at = -1;
    this.shown = MOST;
    this.draw();
  }

  private draw(): void {
    const {diagnostics} = this.session.run.data;
    if (!diagnostics.length) {
      fill(this.element, el('p', {class: 'empty'}, 'No errors, warnings or notes.'));
      return;
    }
    const list = el('ul');
    for (const diagnostic of diagnostics.slice(0, this.shown)) list.append(this.item(diagnostic));
    const rest = diagnostics.length - this.shown;
    fill(
        this.element, el('p', {class: 'facts'}, this.counts()), list,
        rest > 0 &&
            el('button', {type: 'button', onclick: () => ((this.shown += MOST), this.draw())},
               `Show ${Math.min(rest, MOST)} more of ${rest}`));
  }

  private counts(): string {
    const {diagnostics} = this.session.run.data;
    return (['error', 'warning', 'note'] as const)
        .map(
            (severity) => [severity,
                           diagnostics.filter((one) => one.severity === severity).length] as const)
        .filter(([, number]) => number > 0)
        .map(([severity, number]) => plural(number, severity))
        .join(', ');
  }

  private item(diagnostic: Diagnostic): HTMLElement {
    const {file, line, column, severity, code, message, help} = diagnostic;
    const {run} = this.session;
    const name = run.data.files[file]?.name ?? '';
    const place = line > 0 ? `${name}:${line}${column > 0 ? `:${column}` : ''}` : name;
    const text = line > 0 ? run.text(file)?.line(line).replace(/\t/g, ' ') : undefined;
    const from = Math.max(column - 41, 0);  // a long line is cut, so that its caret is seen
    const caret = text !== undefined && column > 0 ?
        `\n${' '.repeat(column - 1 - from + (from ? 1 : 0))}${underline(diagnostic)}` :
        '';
    return el(
        'li', {class: severity},
        el('p', {}, el('span', {class: 'sign', 'aria-hidden': 'true'}, SIGNS[severity]),
           el('b', {}, severity), ' ', message, ' ', el('span', {class: 'code'}, `[${code}]`)),
        line > 0 ?
            el('button', {type: 'button', class: 'link place', onclick: () => this.go(diagnostic)},
               place) :
            place ? el('span', {class: 'place'}, place) :
                    null,
        text !== undefined ?
            el('pre', {}, (from ? '…' : '') + text.slice(from, from + 160) + caret) :
            null,
        help ? el('p', {class: 'help'}, help) : null);
  }

  private go({file, line}: Diagnostic): void {
    if (line < 1) return this.session.show('messages');
    this.session.show('program');
    this.session.select({file, line});
  }
}

/** Returns what marks the place of a diagnostic under its line: ^~~~. */
export function underline({length}: Diagnostic): string {
  return `^${'~'.repeat(Math.min(Math.max((length ?? 1) - 1, 0), MOST_MARKED))}`;
}
