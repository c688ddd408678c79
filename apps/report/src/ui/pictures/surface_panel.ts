// SPDX-License-Identifier: MIT
// The surface that the run leaves: its picture, and the roughness of its regions.
import type {SurfaceData} from '../../data/format.ts';
import {createSurfaceView, type SurfaceView} from '../../view/surface/surface_view.ts';
import {Choice, el, fill} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';
import type {Session} from '../common/session.ts';

type Look = 'height'|'rmax'|'met';

/** The picture of the surface; it is made when it is first looked at. */
export class SurfaceStage {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly canvas = el('div', {class: 'canvas'});
  private readonly choice: Choice;
  private view: SurfaceView|null = null;
  private look: Look = 'height';

  constructor(session: Session) {
    this.session = session;
    this.choice = new Choice(
        'Surface coloured by', [['height', 'Height'], ['rmax', 'Rmax'], ['met', 'Target met']],
        this.look, (look) => this.show(look as Look));
    this.element =
        el('div', {class: 'path', role: 'region', 'aria-label': 'Surface', hidden: true},
           el('div', {class: 'tools'}, this.choice.element,
              el('button', {type: 'button', onclick: () => this.fit()}, 'Fit')),
           el('div', {class: 'stage'}, this.canvas));
    session.on(['theme'], () => this.view?.setTheme(session.dark));
  }

  start(): void {
    const {surface} = this.session.runs[0]!;
    if (this.view || !surface) return;
    try {
      this.view = createSurfaceView(this.canvas, surface);
      this.view.setTheme(this.session.dark);
      this.show(this.look);
      this.view.fit();
    } catch (error) {
      fill(this.canvas, el('p', {class: 'empty'}, `The surface cannot be drawn: ${String(error)}`));
    }
  }

  fit(): void {
    this.view?.fit();
  }

  show(look: Look): void {
    this.look = look;
    this.choice.press(look);
    this.view?.show(look);
  }
}

/** The panel of a surface; its numbers are made when they are first looked at. */
export function surfacePanel(session: Session, data: SurfaceData): HTMLElement {
  const panel = el('div', {class: 'surface'});
  session.on(['tab'], () => {
    if (session.tab === 'surface' && !panel.firstChild) panel.append(surfaceNumbers(session, data));
  });
  return panel;
}

/** Returns the numbers of a surface, with the regions that miss their target most. */
export function surfaceNumbers(session: Session, data: SurfaceData): HTMLElement {
  return el('div', {}, figures(data), worst(session, data));
}

function figures(data: SurfaceData): HTMLElement {
  const {regions_judged: judged, regions_missed: missed} = data;
  const pair = (name: string, value: string) => [el('dt', {}, name), el('dd', {}, value)];
  return el(
      'section', {'aria-label': 'Roughness'}, el('h2', {}, 'Surface'),
      judged > 0 ? el('p', {class: `status ${missed ? 'alarm' : 'done'}`},
                      missed ? `${numbers.plural(missed, 'region')} of ${
                                   numbers.count(judged)} rougher than asked for` :
                               `all ${numbers.plural(judged, 'region')} meet their target`) :
                               null,
      el('dl', {class: 'pairs'}, ...pair('largest Rmax', numbers.withUnit(data.rmax_max_um, 'µm')),
         ...pair('mean Rmax', numbers.withUnit(data.rmax_mean_um, 'µm')),
         ...pair(
             'regions',
             `${data.region_columns} × ${data.region_rows} of ${numbers.plain(data.region_mm)} mm`),
         ...pair(
             'heights',
             `${data.columns} × ${data.rows}, one every ${
                 numbers.plain(data.step_mm * data.heights_step)} mm`)));
}

function worst(session: Session, data: SurfaceData): HTMLElement|null {
  const surface = session.runs[0]!.surface!;
  const misses = [...surface.rmax.keys()]
                     .filter((i) => surface.target[i]! > 0 && surface.rmax[i]! > surface.target[i]!)
                     .sort(
                         (a, b) => surface.rmax[b]! / surface.target[b]! -
                             surface.rmax[a]! / surface.target[a]!)
                     .slice(0, 10);
  if (!misses.length) return null;
  const middle = (i: number, axis: 0|1) => surface.origin[axis] +
      ((axis === 0 ? i % data.region_columns : Math.floor(i / data.region_columns)) + 0.5) *
          data.region_mm;
  const list = el('tbody');
  for (const i of misses)
    list.append(
        el('tr', {},
           ...[`X ${numbers.fixed(middle(i, 0), 2)}  Y ${numbers.fixed(middle(i, 1), 2)}`,
               numbers.significant(surface.rmax[i]!), numbers.significant(surface.target[i]!)]
               .map((text, column) => el('td', {class: column ? 'number' : undefined}, text))));
  return el(
      'section', {'aria-label': 'Regions that miss their target'},
      el('h2', {}, 'Regions that miss their target most'),
      el('div', {class: 'scroll-x'},
         el('table', {},
            el('thead', {},
               el('tr', {}, el('th', {scope: 'col'}, 'Middle, mm'),
                  el('th', {scope: 'col', class: 'number'}, 'Rmax, µm'),
                  el('th', {scope: 'col', class: 'number'}, 'Target, µm'))),
            list)));
}
