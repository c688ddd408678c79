// SPDX-License-Identifier: MIT
// The path with its menus, legend and the description of what the pointer is at.
import type {Side} from '../../view/common/camera.ts';
import {createPathView, type PathView} from '../../view/path/path_view.ts';
import {chip, Choice, el, fill, select, swatch} from '../common/dom.ts';
import {limitColour, limitName} from '../common/limits.ts';
import {coloursOf, quantitiesOf, scaleOf, toolsOf, type QuantityId} from '../common/quantities.ts';
import type {Session} from '../common/session.ts';
import {dim, visibleNodes} from './filters.ts';
import {legend} from './legend.ts';
import {Layers} from './layers.ts';
import {drawnPath, hasDepth, spread, type DrawnPath} from './path_layers.ts';
import {placeTip, tipLines} from './path_tip.ts';

const SIDES: Array<[Side, string]> =
    [['top', 'Top'], ['front', 'Front'], ['right', 'Right'], ['isometric', 'Isometric']];

const REST_MS = 200;  // after the last step of a zoom

export class PathPanel {
  readonly element: HTMLElement;
  view: PathView|null = null;
  private readonly session: Session;
  private readonly canvas = el('div', {class: 'canvas'});
  private readonly legend = el('div', {class: 'legend'});
  private readonly tip = el('div', {class: 'tip', role: 'tooltip'});
  private readonly tools = el('div', {class: 'tools'});
  private readonly mode: Choice;
  private readonly layers: Layers;
  private readonly sides: HTMLSelectElement;
  private menu?: HTMLSelectElement;
  private flat: boolean;
  private paths: DrawnPath[] = [];
  private pending = 0;
  private resting = 0;

  constructor(session: Session) {
    this.session = session;
    this.flat = !hasDepth(session.runs);
    this.mode = new Choice(
        'View', [['2d', '2-D'], ['3d', '3-D']], this.flat ? '2d' : '3d',
        (mode) => this.setMode(mode as '2d' | '3d'));
    this.sides = select(
        'Look at the path from (Shift+T, F, R, I)', [['', 'View'], ...SIDES], '',
        (side) => this.lookFrom(side as Side | ''));
    this.layers = new Layers(session, (fits) => {
      this.drawLayers();
      if (fits) this.fit();
    });
    this.element =
        el('div', {class: 'path', role: 'region', 'aria-label': 'Path'}, this.tools, this.legend,
           el('div', {class: 'stage'}, this.canvas, this.tip));
    if (!session.runs.some(({moves}) => moves)) return;
    session.on(['colour', 'theme', 'filter'], () => this.colourLater());
    session.on(['zoom'], () => this.colourAfterZoom());
    session.on(['filter'], () => this.filter());
    session.on(['filter', 'run', 'lines'], () => this.drawTools());
    session.on(['lines'], () => this.setPaths());
    session.on(['filter'], () => this.drawLayers());
    session.on(['selection', 'run'], () => this.highlight());
    session.on(['row', 'hover', 'run'], () => this.mark());
    this.drawTools();
  }

  /**
   * Gives the view its paths. Call once the panel is on the page, since the view needs its size.
   */
  start(): void {
    if (!this.session.runs.some(({moves}) => moves)) return;
    this.view = this.create();
    if (!this.view) return;
    this.view.setTheme(this.session.dark);
    this.view.setMode(this.flat ? '2d' : '3d');
    this.drawLayers();
    this.setPaths();
  }

  /** Gives the view the paths, or the part of them that is shown. */
  private setPaths(): void {
    const {session, view} = this;
    if (!view) return;
    this.paths = session.runs.map((run, i) => drawnPath(run, session.stays[i] ?? []));
    view.setLayers(this.paths.map(({layer}) => layer));
    this.colour();
    this.filter();
    this.highlight();
    view.fit();
    this.mark();
  }

  setMode(mode: '2d'|'3d'): void {
    this.flat = mode === '2d';
    this.mode.press(mode);
    this.sides.value = '';
    this.view?.setMode(mode);
  }

  /** Looks at the path in space from a side; an empty one leaves the picture as it is. */
  lookFrom(side: Side|''): void {
    if (!side) return;
    this.flat = false;
    this.mode.press('3d');
    this.sides.value = side;
    this.view?.lookFrom(side);
  }

  fit(): void {
    this.view?.fit();
  }

  /** Colours by the next quantity of the menu. */
  nextQuantity(): void {
    const all = quantitiesOf(this.session.runs);
    const now = all.findIndex(({id}) => id === this.session.quantity);
    this.session.setQuantity(all[(now + 1) % all.length]!.id);
  }

  private create(): PathView|null {
    try {
      const view = createPathView(this.canvas);
      view.onTurn(() => (this.sides.value = ''));
      view.onPick((hit) => hit && this.pick(hit.layer, hit.row));
      view.onHover((hit, event) => this.hover(hit, event));
      return view;
    } catch (error) {
      fill(this.canvas, el('p', {class: 'empty'}, `The path cannot be drawn: ${String(error)}`));
      return null;
    }
  }

  private drawTools(): void {
    const {session} = this;
    const quantities =
        quantitiesOf(session.runs).map(({id, label}): [string, string] => [id, label]);
    this.menu = select(
        'Colour the path by', quantities, session.quantity,
        (id) => session.setQuantity(id as QuantityId));
    fill(
        this.tools, el('label', {}, el('span', {class: 'word'}, 'Colour'), this.menu),
        this.mode.element, this.sides,
        el('button', {type: 'button', onclick: () => this.fit(), title: 'Show the whole path (f)'},
           'Fit'),
        this.layers.element, this.toolMenu(), session.runs.length > 1 && this.runs(), this.limitChip(),
        this.linesChip());
  }

  private toolMenu(): HTMLElement|null {
    const {session} = this;
    const tools = toolsOf(session.runs);
    if (tools.length < 2) return null;
    const names = tools.map((tool): [string, string] => [String(tool), `T${tool}`]);
    const menu = select(
        'Show only one tool', [['', 'all'], ...names],
        session.tool === null ? '' : String(session.tool),
        (value) => session.setTool(value === '' ? null : Number(value)));
    return el('label', {}, el('span', {class: 'word'}, 'Tool'), menu);
  }

  /** The limit whose stretches alone are shown; a click shows all again. */
  private limitChip(): HTMLElement|null {
    const {session} = this;
    if (session.limit === null) return null;
    return chip(
        'Show all stretches again', () => session.setLimit(null),
        swatch(limitColour(session.limit)), `only ${limitName(session.limit)} ✕`);
  }

  /** The lines that alone are shown; a click shows all again. */
  private linesChip(): HTMLElement|null {
    const {session} = this;
    if (!session.lines) return null;
    const {first, last} = session.lines;
    const which = first === last ? `line ${first}` : `lines ${first}–${last}`;
    return chip('Show all lines again', () => session.setLines(null), `only ${which} ✕`);
  }

  private runs(): HTMLElement {
    const [a, b] = this.session.shown;
    return new Choice(
               'Runs that are shown', [['ab', 'A + B'], ['a', 'A'], ['b', 'B']],
               a && b ? 'ab' :
                   a  ? 'a' :
                        'b',
               (value) => this.session.setShown([value !== 'b', value !== 'a']))
        .element;
  }

  /** Colours once per frame, however often something changes. */
  private colourLater(): void {
    this.pending ||= requestAnimationFrame(() => {
      this.pending = 0;
      this.colour();
    });
  }

  /** Colours once a zoom of the charts has come to rest. */
  private colourAfterZoom(): void {
    window.clearTimeout(this.resting);
    this.resting = window.setTimeout(() => this.colourLater(), REST_MS);
  }

  /** Colours the path at once. */
  colour(): void {
    const {session, view} = this;
    const quantity = quantitiesOf(session.runs).find(({id}) => id === session.quantity);
    if (!view || !quantity) return;
    view.setTheme(session.dark);
    const scale = scaleOf(session.runs, quantity);
    session.runs.forEach((run, i) => {
      const rgb = dim(session, run, coloursOf(session.runs, i, quantity, scale, session.dark));
      view.setColours(i, spread(this.paths[i]!, rgb, 3));
    });
    fill(this.legend, legend(session, quantity, scale));
    if (this.menu) this.menu.value = session.quantity;
  }

  /** Shows the runs and the tool that are chosen. */
  private filter(): void {
    const {session, view} = this;
    if (!view) return;
    session.runs.forEach(
        (run, i) => view.setVisible(i, visibleNodes(session, run, i, this.paths[i]!)));
  }

  private drawLayers(): void {
    this.view?.setScenery(this.layers.scenery());
  }

  private highlight(): void {
    const {selection, active} = this.session;
    this.view?.highlight((selection?.ranges ?? []).map((range) => ({layer: active, ...range})));
  }

  private mark(): void {
    const {session, view} = this;
    if (!view) return;
    const row = session.hover ?? session.row;
    const seconds = session.run.secondsAt(row);
    session.runs.forEach((run, i) => {
      const here = i === session.active ? row : run.rowAtSeconds(seconds);
      view.setMarker(i, session.shown[i] && run.moves ? here : null);
    });
  }

  private pick(layer: number, row: number): void {
    if (layer !== this.session.active) this.session.setActive(layer);
    this.session.selectAt(row);
  }

  private hover(hit: {layer: number; row: number}|null, event: PointerEvent): void {
    this.tip.hidden = !hit;
    this.session.setHover(hit && this.activeRow(hit.layer, hit.row));
    if (!hit) return;
    const {runs} = this.session;
    const letter = runs.length > 1 ? 'AB'[hit.layer]! : '';
    fill(this.tip, ...tipLines(runs[hit.layer]!, letter, hit.row));
    placeTip(this.tip, event, this.canvas.getBoundingClientRect());
  }

  /** The row of the run that is looked at, at the time of a row of any run. */
  private activeRow(layer: number, row: number): number {
    const {runs, run, active} = this.session;
    return layer === active ? row : run.rowAtSeconds(runs[layer]!.secondsAt(row));
  }
}
