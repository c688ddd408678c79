// SPDX-License-Identifier: MIT
// The program, line by line, with the time of each line and the diagnostics at their places. Only
// the lines on the screen are elements of the page.
import {lowerBound} from '../../data/bisection.ts';
import type {Diagnostic} from '../../data/format.ts';
import {isWithin, type Place} from '../../data/run_model.ts';
import {el, fill, select} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';
import {Pace} from '../common/pace.ts';
import type {Session} from '../common/session.ts';
import {lineRow, noteRows} from './listing_rows.ts';
import {RangeBar} from './range_bar.ts';

const ROW = 20;       // px
const NOTES = 3;      // rows that a diagnostic takes: its mark, and two of text
const TALLEST = 8e6;  // px; browsers cannot scroll much more

export class Listing {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly viewport: HTMLElement;
  private readonly space = el('div', {class: 'space'});
  private readonly rows = el('div', {class: 'rows', role: 'presentation'});
  private readonly tools = el('div', {class: 'tools'});
  private readonly search: HTMLInputElement;
  private readonly found = el('span', {class: 'found', role: 'status'});
  private file = 0;
  private count = 0;
  private notes: Diagnostic[] = [];  // of this file, by line
  private noteLines: number[] = [];
  private drawn = false;
  private readonly pace = new Pace(() => this.followTool());
  private now = 0;     // line that the tool is on
  private anchor = 0;  // line that a range begins or ends with
  private head = 0;    // its other end, or the line that was chosen last

  constructor(session: Session) {
    this.session = session;
    this.viewport =
        el('div', {
          class: 'listing',
          tabIndex: 0,
          role: 'listbox',
          'aria-label': 'Lines of the program',
          'aria-multiselectable': 'true',
          onscroll: () => this.draw(),
          onkeydown: (event: KeyboardEvent) => this.key(event)
        },
           this.space, this.rows);
    this.search = el('input', {
      type: 'search',
      placeholder: 'Search, or line number',
      'aria-label': 'Search the program, or go to a line',
      onkeydown: (event: KeyboardEvent) => this.searchKey(event)
    });
    const range = new RangeBar(session, () => this.file);
    this.element = el('div', {class: 'program'}, this.tools, range.element, this.viewport);
    this.rows.addEventListener('click', (event) => this.click(event));
    // A click with Shift would select text.
    this.rows.addEventListener('mousedown', (event) => event.shiftKey && event.preventDefault());
    session.on(['run'], () => this.open(0));
    session.on(['selection', 'lines'], () => this.follow());
    session.on(['tab'], () => session.tab === 'program' && queueMicrotask(() => this.shown()));
    session.on(['row', 'hover'], () => this.pace.request());
    new ResizeObserver(() => this.draw()).observe(this.viewport);
    this.open(0);
  }

  focusSearch(): void {
    this.search.focus();
    this.search.select();
  }

  private open(file: number): void {
    const {run} = this.session;
    this.file = file;
    this.drawn = false;
    this.anchor = this.head = 0;
    this.notes = run.data.diagnostics.filter((note) => note.file === file && note.line > 0)
                     .sort((a, b) => a.line - b.line);
    this.noteLines = this.notes.map(({line}) => line);
    const files = run.data.files.map(({name}, i): [string, string] => [String(i), name]);
    this.found.textContent = '';
    const withoutText = !run.data.files[file]?.text;
    fill(
        this.tools,
        files.length > 1 &&
            select('File', files, String(file), (value) => this.open(Number(value))),
        this.search, this.found,
        withoutText &&
            el('p', {class: 'facts'}, 'The report has the times of the lines, not their text.'));
    if (this.session.tab === 'program') this.shown();
  }

  /** Counts the lines when the program is first looked at. */
  private shown(): void {
    if (!this.drawn) {
      this.drawn = true;
      this.count = this.session.run.lineCount(this.file);
      this.space.style.height = `${Math.min(this.height, TALLEST)}px`;
      const digits = String(this.count).length;
      this.element.style.setProperty('--digits', `${Math.max(digits, 2)}ch`);
      if (this.selectedLine) this.reveal(this.selectedLine);
    }
    this.draw();
  }

  private get height(): number {
    return (this.count + NOTES * this.notes.length) * ROW;
  }

  /** Scrolls further than the browser where the program is taller than a page may be. */
  private get top(): number {
    const {scrollTop, clientHeight} = this.viewport;
    const room = Math.min(this.height, TALLEST) - clientHeight;
    return this.height <= TALLEST || room <= 0 ? scrollTop :
                                                 (scrollTop / room) * (this.height - clientHeight);
  }

  private topOf(line: number): number {
    return (line - 1 + NOTES * lowerBound(this.noteLines, line)) * ROW;
  }

  /** Scrolls to a line without choosing it. */
  look({file, line}: Place): void {
    if (file !== this.file) this.open(file);
    queueMicrotask(() => {
      this.shown();
      this.reveal(line);
      this.draw();
    });
  }

  private reveal(line: number): void {
    const {clientHeight} = this.viewport;
    const top = this.topOf(line);
    if (top >= this.top && top + ROW <= this.top + clientHeight) return;
    const wanted = Math.max(top - clientHeight / 3, 0);
    this.viewport.scrollTop = this.height <= TALLEST ?
        wanted :
        (wanted / (this.height - clientHeight)) * (TALLEST - clientHeight);
  }

  private follow(): void {
    const {selection, tab} = this.session;
    if (selection && selection.file !== this.file && this.session.run.data.files[selection.file])
      this.open(selection.file);
    if (selection) this.anchor = this.head = selection.line;
    if (tab !== 'program' || !this.drawn) return;
    if (selection) this.reveal(selection.line);
    this.draw();
  }

  /** Marks the line that is executed, and keeps it on the screen while the run is played. */
  private followTool(): void {
    const {session} = this;
    if (session.tab !== 'program' || !this.drawn) return;
    const place = session.run.placeAt(session.hover ?? session.row);
    const line = place?.file === this.file ? place.line : 0;
    if (line === this.now) return;
    this.now = line;
    if (session.playing && line) this.reveal(line);
    this.draw();
  }

  private draw(): void {
    if (!this.drawn) return;
    const selected = this.selectedLine;
    if (selected)
      this.viewport.setAttribute('aria-activedescendant', `line-${selected}`);
    else
      this.viewport.removeAttribute('aria-activedescendant');
    const {scrollTop, clientHeight} = this.viewport;
    const top = this.top;
    this.rows.style.setProperty('--view', `${this.viewport.clientWidth}px`);
    const longest = this.session.run.longestLine;
    fill(this.rows);
    let line = this.firstLine(top);
    this.rows.style.top = `${scrollTop + this.topOf(line) - top}px`;
    for (let y = this.topOf(line) - top; y < clientHeight && line <= this.count; ++line) {
      this.rows.append(this.row(line, longest));
      y += ROW;
      for (let i = lowerBound(this.noteLines, line); this.noteLines[i] === line;
           ++i, y += NOTES * ROW)
        this.rows.append(...noteRows(this.notes[i]!));
    }
  }

  /** The last line that begins at or above a height. */
  private firstLine(top: number): number {
    let low = 1;
    let high = Math.max(this.count, 1);
    while (low < high) {
      const middle = (low + high + 1) >>> 1;
      if (this.topOf(middle) <= top)
        low = middle;
      else
        high = middle - 1;
    }
    return low;
  }

  private row(line: number, longest: number): HTMLElement {
    const {run, lines} = this.session;
    return lineRow({
      line,
      text: run.text(this.file)?.line(line) ?? '',
      time: run.lineTime({file: this.file, line}),
      longest,
      selected: this.selectedLine === line,
      within: lines !== null && isWithin(lines, {file: this.file, line}),
      remarked: this.noteLines[lowerBound(this.noteLines, line)] === line,
      now: line === this.now,
    });
  }

  /** The selected line if it is of this file, otherwise 0. */
  private get selectedLine(): number {
    const {selection} = this.session;
    return selection?.file === this.file ? selection.line : 0;
  }

  private click(event: MouseEvent): void {
    const line = Number((event.target as Element).closest<HTMLElement>('.line')?.dataset['line']);
    if (!line) return;
    if (event.shiftKey)
      this.extendTo(line);
    else
      this.session.select({file: this.file, line});
  }

  /** Shows the lines from the one that was chosen to this one alone. */
  private extendTo(line: number): void {
    const to = Math.min(Math.max(line, 1), this.count);
    this.head = to;
    this.session.setLines({file: this.file, first: this.anchor || to, last: to});
    this.anchor ||= to;
    this.reveal(to);
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const page = Math.max(Math.floor(this.viewport.clientHeight / ROW) - 1, 1);
    const now = this.selectedLine || this.head;
    const to = {
      ArrowDown: now + 1,
      ArrowUp: now - 1,
      PageDown: now + page,
      PageUp: now - page,
      Home: 1,
      End: this.count,
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.shiftKey)
      this.extendTo(to);
    else
      this.goTo(to);
  }

  goTo(line: number): void {
    if (this.count)
      this.session.select({file: this.file, line: Math.min(Math.max(line, 1), this.count)});
  }

  private searchKey(event: KeyboardEvent): void {
    event.stopPropagation();
    if (event.key === 'Escape') this.viewport.focus();
    if (event.key !== 'Enter') return;
    const wanted = this.search.value.trim();
    if (/^\d+$/.test(wanted)) {
      this.found.textContent =
          Number(wanted) > this.count ? `${numbers.count(this.count)} lines` : '';
      this.goTo(Number(wanted));
      return;
    }
    const from = Math.max(this.selectedLine, event.shiftKey ? 1 : 0);
    const line = this.session.run.text(this.file)?.find(wanted, from, event.shiftKey) ?? 0;
    this.found.textContent = line || !wanted ? '' : 'not found';
    if (line) this.goTo(line);
  }
}
