// SPDX-License-Identifier: MIT
// Plays a run: start and stop, a slider over its time, the speed factor, and where the tool is.
import {el, fill, select, swatch} from '../common/dom.ts';
import {limitColour, limitName} from '../common/limits.ts';
import * as numbers from '../common/numbers.ts';
import {Pace} from '../common/pace.ts';
import type {Session} from '../common/session.ts';

const STEPS = 10000;  // of the slider
const FACTORS: Array<[string, string]> = [
  ['0.05', '1/20 ×'], ['0.1', '1/10 ×'], ['0.25', '1/4 ×'], ['1', '1 ×'], ['2', '2 ×'],
  ['5', '5 ×'], ['10', '10 ×'], ['60', '60 ×'], ['fit', 'all in 20 s']
];
const FIT_SECONDS = 20;

export class Player {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly button: HTMLButtonElement;
  private readonly slider: HTMLInputElement;
  private readonly clock = el('output', {class: 'clock', 'aria-label': 'Time'});
  private readonly state = el('div', {class: 'state', 'aria-live': 'off'});
  private readonly texts = new Pace(() => this.draw());
  private factor = 'fit';
  private last = 0;

  constructor(session: Session) {
    this.session = session;
    this.button = el('button', {type: 'button', class: 'play', onclick: () => this.toggle()});
    this.slider = el('input', {
      type: 'range',
      min: '0',
      max: String(STEPS),
      step: '1',
      value: '0',
      'aria-label': 'Time of the run',
      oninput: () => this.scrub()
    });
    const speed =
        select('Speed of playing', FACTORS, this.factor, (value) => (this.factor = value));
    this.element =
        el('div', {class: 'player', role: 'group', 'aria-label': 'Player'},
           el('div', {class: 'controls'}, this.button, this.slider, this.clock, speed), this.state);
    session.on(['row', 'run'], () => (session.playing ? this.texts.request() : this.texts.now()));
    session.on(['hover'], () => this.texts.request());
    session.on(['playing'], () => {
      this.label();
      this.texts.now();
    });
    this.label();
    this.draw();
  }

  toggle(): void {
    const {session} = this;
    if (!session.run.moves) return;
    if (!session.playing && session.row >= session.run.lastRow) session.moveTo(0);
    session.setPlaying(!session.playing);
    this.last = performance.now();
    if (session.playing) requestAnimationFrame((now) => this.frame(now));
  }

  private frame(now: number): void {
    const {session} = this;
    if (!session.playing) return;
    const seconds = Math.max(now - this.last, 0) / 1e3;
    this.last = now;
    const whole = session.run.secondsAt(session.run.lastRow);
    const factor = this.factor === 'fit' ? whole / FIT_SECONDS : Number(this.factor);
    session.moveTo(session.row + (seconds * factor) / session.run.data.period_s);
    if (session.row >= session.run.lastRow)
      session.setPlaying(false);
    else
      requestAnimationFrame((next) => this.frame(next));
  }

  private scrub(): void {
    this.session.moveTo((Number(this.slider.value) / STEPS) * this.session.run.lastRow);
  }

  private label(): void {
    const {playing} = this.session;
    this.button.textContent = playing ? '❚❚' : '▶';
    this.button.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    this.button.title = `${playing ? 'Pause' : 'Play'} (space)`;
  }

  private draw(): void {
    const {run} = this.session;
    this.element.classList.toggle('off', !run.moves);
    if (!run.moves) return;
    const row = this.session.hover ?? this.session.row;
    this.slider.value = String(Math.round((this.session.row / run.lastRow) * STEPS));
    this.slider.setAttribute('aria-valuetext', numbers.instant(run.secondsAt(this.session.row)));
    this.clock.textContent = numbers.instant(run.secondsAt(row));
    fill(this.state, ...this.place(row));
  }

  private place(row: number): Array<Node|string> {
    const {run} = this.session;
    const node = run.nodeAt(row);
    const place = run.placeAt(row);
    const limit = run.data.limits[run.column('limit')[node]!] ?? '';
    const programmed = run.column('feed')[node]!;
    const v = run.valueAt('v', row);
    const motion = run.column('motion')[node];
    const speed = motion === 2 ? `rapid ${numbers.feed(v)}` :
        motion === 0   ? 'at rest' :
        programmed > 0 ? `${numbers.feedNumber(v)} of ${numbers.feed(programmed)}` :
                         numbers.feed(v);
    const position = run.data.axes.map(
        (axis) => `${axis.toUpperCase()} ${numbers.fixed(run.valueAt(axis, row), 3)}`);
    const text = place && run.text(place.file)?.line(place.line).trim();
    return [
      el('span', {}, speed),
      el('span', {}, swatch(limitColour(limit)), limitName(limit)),
      el('span', {class: 'position'}, position.join('  ')),
      place ? el('span', {class: 'text'}, `line ${numbers.count(place.line)}`, text ? ': ' : '',
                 text ? el('code', {}, text.slice(0, 120)) : null) :
              '',
    ];
  }
}
