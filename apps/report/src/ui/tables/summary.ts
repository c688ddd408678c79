// SPDX-License-Identifier: MIT
// The first screen: time, share by limit, and the lines that lose most time.
import type {WorstLine} from '../../data/format.ts';
import {el, fill, swatch} from '../common/dom.ts';
import {limitColour, limitMeaning, limitName} from '../common/limits.ts';
import * as numbers from '../common/numbers.ts';
import type {Session} from '../common/session.ts';
import {statusText} from '../common/status.ts';

const NOISE = 1e-6;       // what rounding leaves of errors that are none
const COARSE_UM = 10;     // of the drawing: less cannot be seen
const SHOWN_FIGURES = 3;  // the others are among the details

export class Summary {
  readonly element = el('div', {class: 'summary'});
  private readonly session: Session;
  private worst: Array<{line: WorstLine; item: HTMLElement}> = [];

  constructor(session: Session) {
    this.session = session;
    session.on(['run', 'filter'], () => this.draw());
    session.on(['selection'], () => this.mark());
    this.draw();
  }

  private draw(): void {
    fill(this.element, this.time(), this.limits(), this.lines());
    this.mark();
  }

  private time(): HTMLElement {
    const {data} = this.session.run;
    const facts = [
      data.length_mm ? `path ${numbers.length(data.length_mm)}` : '',
      data.blocks ? numbers.plural(data.blocks, 'block') : '',
      data.rests?.count ?
          `${numbers.plural(data.rests.count, 'rest')}, ${numbers.time(data.rests.seconds)}` :
          '',
      data.error_um > COARSE_UM ? `drawn within ${numbers.withUnit(data.error_um, 'µm')}` : '',
    ].filter(Boolean);
    const figures = data.figures.filter(({value}) => Math.abs(value) > NOISE)
                        .slice(0, SHOWN_FIGURES)
                        .map(({name, value, unit}) => `${name} ${numbers.withUnit(value, unit)}`);
    const status =
        data.status === 'done' ? null : el('p', {class: `status ${data.status}`}, statusText(data));
    return el(
        'section', {'aria-label': 'Time'},
        el('p', {class: 'big'}, this.session.run.moves ? numbers.time(data.time_s) : 'No motion',
           this.change()),
        status, factLine(facts), factLine(figures));
  }

  private change(): HTMLElement|null {
    const {comparison} = this.session.report;
    if (!comparison) return null;
    const [a, b] = comparison.time_s;
    return el(
        'small', {}, ` A ${numbers.time(a)} → B ${numbers.time(b)} (${numbers.timeChange(b - a)})`);
  }

  private limits(): HTMLElement|null {
    const {time_by_limit_s: times} = this.session.run.data;
    const total = times.reduce((sum, {seconds}) => sum + seconds, 0);
    if (!total) return null;
    const bar = el('div', {class: 'share', 'aria-hidden': 'true'});
    const list = el('ul', {class: 'limits'});
    for (const {limit, seconds} of times) {
      const label =
          `${limitName(limit)}: ${numbers.time(seconds)}, ${numbers.share(seconds / total)}`;
      bar.append(
          el('span',
             {style: `flex:${seconds / total};background:${limitColour(limit)}`, title: label}));
      list.append(el(
          'li', {},
          el('button', {
            type: 'button',
            class: 'row',
            title: `${limitName(limit)}: ${limitMeaning(limit)}. Click to show only its stretches.`,
            'aria-pressed': String(this.session.limit === limit),
            onclick: () => this.session.setLimit(this.session.limit === limit ? null : limit),
          },
             swatch(limitColour(limit)), el('span', {class: 'name'}, limitName(limit)),
             el('span', {class: 'number'}, numbers.time(seconds)),
             el('span', {class: 'number percent'}, numbers.share(seconds / total)))));
    }
    return el('section', {'aria-label': 'Time by limit'}, el('h2', {}, 'Limited by'), bar, list);
  }

  private lines(): HTMLElement|null {
    const {data} = this.session.run;
    this.worst = [];
    if (!this.session.run.moves) return null;
    const list = el('ol', {class: 'worst'});
    for (const line of data.worst_lines) {
      const item = el(
          'button', {
            type: 'button',
            class: 'worst-line',
            onclick: () => this.session.select({file: line.file, line: line.line}),
          },
          el('span', {class: 'head'}, swatch(limitColour(line.limit)),
             el('b', {}, `Line ${numbers.count(line.line)}`),
             line.file > 0 ? el('span', {class: 'file'}, data.files[line.file]?.name ?? '') : null,
             el('span', {class: 'number'},
                `${numbers.time(line.lost_s)} lost of ${numbers.time(line.seconds)}`)),
          el('span', {class: 'sentence'}, line.sentence));
      this.worst.push({line, item});
      list.append(el('li', {}, item));
    }
    return el(
        'section', {'aria-label': 'Lines that lose most time'},
        el('h2', {
          title: 'Time of the line less its length over the programmed feed, in all of its rounds'
        },
           'Lines that lose most time against their feed'),
        data.worst_lines.length ?
            list :
            el('p', {class: 'empty'}, 'No line is slower than its programmed feed.'));
  }

  /** Selects the next or the previous of these lines. */
  step(by: 1|- 1): void {
    if (!this.worst.length) return;
    const now = this.worst.findIndex(({item}) => item.classList.contains('selected'));
    const next = now < 0 ? (by > 0 ? 0 : this.worst.length - 1) :
                           (now + by + this.worst.length) % this.worst.length;
    const {file, line} = this.worst[next]!.line;
    this.session.select({file, line});
  }

  private mark(): void {
    const {selection} = this.session;
    for (const {line, item} of this.worst) {
      const selected = selection?.line === line.line && selection.file === line.file;
      item.classList.toggle('selected', selected);
      item.setAttribute('aria-pressed', String(selected));
    }
  }
}

/** Facts in a line, each of which is kept together. */
function factLine(facts: string[]): HTMLElement {
  const line = el('p', {class: 'facts'});
  for (const fact of facts) line.append(el('span', {class: 'fact'}, fact), ' ');
  return line;
}
