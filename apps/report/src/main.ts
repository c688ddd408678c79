// SPDX-License-Identifier: MIT
// The report page: takes the data out of the page, and puts the panels on it.
import 'uplot/dist/uPlot.min.css';
import './style/page.css';
import './style/tables.css';
import './style/program.css';
import './style/pictures.css';
import './style/charts.css';
import './style/print.css';
import {embeddedData, type Embedded} from './data/blob.ts';
import {Charts} from './ui/charts/charts.ts';
import {el, fill} from './ui/common/dom.ts';
import {Session} from './ui/common/session.ts';
import {header} from './ui/frame/header.ts';
import {inspect} from './ui/frame/inspection.ts';
import {listen, shortcutDialog} from './ui/frame/keyboard.ts';
import {prepareSheet} from './ui/frame/print.ts';
import {shortcuts} from './ui/frame/shortcuts.ts';
import {Tabs, type Tab} from './ui/frame/tabs.ts';
import {followTheme} from './ui/frame/theme.ts';
import {PathPanel} from './ui/pictures/path_panel.ts';
import {Player} from './ui/pictures/player.ts';
import {SurfaceStage, surfacePanel} from './ui/pictures/surface_panel.ts';
import {Listing} from './ui/program/listing.ts';
import {Messages} from './ui/program/messages.ts';
import {comparePanel} from './ui/tables/compare.ts';
import {detailsPanel} from './ui/tables/details.ts';
import {Summary} from './ui/tables/summary.ts';
import {whatIfPanel} from './ui/tables/what_if.ts';

const app = document.getElementById('app')!;

/** Puts the page together: panels at the side, the path, the player and the charts. */
function show({report, blob}: Embedded): void {
  const session = new Session(report, blob);
  followTheme(session);
  const summary = new Summary(session);
  const listing = new Listing(session);
  const messages = new Messages(session);
  const path = new PathPanel(session);
  const surface = new SurfaceStage(session);
  const player = new Player(session);
  const charts = new Charts(session);
  const tabs = new Tabs(session, panels(session, {summary, listing, messages}));
  switchPictures(session, path, surface);
  const keys = shortcuts({
    session,
    summary,
    listing,
    messages,
    path,
    surface,
    player,
    charts,
    tabs,
    help: () => dialog.showModal()
  });
  const dialog = shortcutDialog(keys);
  const sheet = el('div', {class: 'sheet'});
  fill(
      app, header(session, () => dialog.showModal()),
      el('main', {}, tabs.element, path.element, surface.element, player.element, charts.element),
      sheet, dialog);
  listen(keys);
  addEventListener('beforeprint', () => prepareSheet({session, path, summary, messages}, sheet));
  lookAtFirst(session, listing);
  path.start();
  inspect(session, path);
  // The charts come after the first picture.
  requestAnimationFrame(() => setTimeout(() => charts.start()));
}

/** The panels at the side, in their order; some exist only where the report has their data. */
function panels(
    session: Session,
    {summary, listing, messages}: {summary: Summary, listing: Listing, messages: Messages}): Tab[] {
  const {comparison, what_if: whatIf} = session.report;
  const {surface} = session.runs[0]!.data;
  const all: Array<Tab|false|undefined> = [
    {id: 'summary', title: 'Summary', panel: summary.element},
    comparison && {id: 'compare', title: 'Compare', panel: comparePanel(session, comparison)},
    {id: 'program', title: 'Program', panel: listing.element},
    {
      id: 'messages',
      title: 'Messages',
      badge: String(session.run.data.diagnostics.length || ''),
      panel: messages.element
    },
    whatIf && {id: 'whatif', title: 'What if', panel: whatIfPanel(whatIf)},
    surface && {id: 'surface', title: 'Surface', panel: surfacePanel(session, surface)},
    {id: 'details', title: 'Details', panel: detailsPanel(session)},
  ];
  return all.filter((tab): tab is Tab => Boolean(tab));
}

/** Shows the surface beside its panel, and the path beside all others. */
function switchPictures(session: Session, path: PathPanel, surface: SurfaceStage): void {
  session.on(['tab'], () => {
    surface.element.hidden = session.tab !== 'surface';
    path.element.hidden = session.tab === 'surface';
    if (session.tab === 'surface') surface.start();
  });
}

/** Opens the panel that matters most: the program where it has errors, or the comparison. */
function lookAtFirst(session: Session, listing: Listing): void {
  const {diagnostics} = session.run.data;
  const first = diagnostics.find(({severity, line}) => severity === 'error' && line > 0);
  const moves = session.runs.some((run) => run.moves);
  document.body.classList.toggle('still', !moves);
  if (first || (!moves && diagnostics.length))
    session.show('program');
  else if (session.report.comparison)
    session.show('compare');
  if (first) listing.look(first);
}

function failed(error: unknown): void {
  fill(
      app,
      el('p', {class: 'empty', role: 'alert'},
         `This report cannot be read: ${error instanceof Error ? error.message : String(error)}`));
}

embeddedData(document)
    .then((data) => {
      if (data)
        show(data);
      else
        fill(
            app,
            el('p', {class: 'empty'},
               'This page holds no report: "softcnc report" puts one into it.'));
    })
    .catch(failed);
