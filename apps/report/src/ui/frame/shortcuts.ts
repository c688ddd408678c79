// SPDX-License-Identifier: MIT
// The keys of the page.
import type {Side} from '../../view/common/camera.ts';
import type {Charts} from '../charts/charts.ts';
import type {Session} from '../common/session.ts';
import type {PathPanel} from '../pictures/path_panel.ts';
import type {Player} from '../pictures/player.ts';
import type {SurfaceStage} from '../pictures/surface_panel.ts';
import type {Listing} from '../program/listing.ts';
import type {Messages} from '../program/messages.ts';
import type {Summary} from '../tables/summary.ts';
import type {Shortcut} from './keyboard.ts';
import type {Tabs} from './tabs.ts';

export interface Parts {
  session: Session;
  summary: Summary;
  listing: Listing;
  messages: Messages;
  path: PathPanel;
  surface: SurfaceStage;
  player: Player;
  charts: Charts;
  tabs: Tabs;
  help: () => void;
}

const SIDES: Record<string, Side> = {
  T: 'top',
  F: 'front',
  R: 'right',
  I: 'isometric'
};

const SMALL = 0.01;  // of what the charts show
const LARGE = 0.1;

/** Returns all keys with what they do. */
export function shortcuts(parts: Parts): Shortcut[] {
  return [
    ...timeKeys(parts), ...panelKeys(parts), ...chartKeys(parts), ...pictureKeys(parts),
    ...pageKeys(parts)
  ];
}

function timeKeys({session, player}: Parts): Shortcut[] {
  const move = (part: number) => {
    const {from, to} = session.zoom ?? {from: 0, to: session.run.lastRow};
    session.moveTo(session.row + part * (to - from));
  };
  const line = (by: 1|- 1) => {
    const next = session.run.placeInTime(session.row, by);
    if (next) session.select(next.place, next.row);
  };
  return [
    {keys: [' '], shown: 'Space', what: 'play or pause', run: () => player.toggle()},
    {
      keys: ['ArrowLeft', 'ArrowRight'],
      shown: '← →',
      what: 'move in time; with Shift, further',
      run: ({key, shiftKey}) => move((key === 'ArrowLeft' ? -1 : 1) * (shiftKey ? LARGE : SMALL))
    },
    {
      keys: [',', '.'],
      what: 'line before or after, in time',
      run: ({key}) => line(key === '.' ? 1 : -1)
    },
  ];
}

function panelKeys({session, summary, listing, messages, tabs}: Parts): Shortcut[] {
  const search = () => {
    session.show('program');
    queueMicrotask(() => listing.focusSearch());
  };
  return [
    {
      keys: ['n', 'p'],
      what: 'next or previous of the lines that lose most time',
      run: ({key}) => summary.step(key === 'n' ? 1 : -1)
    },
    {
      keys: ['e', 'E'],
      what: 'next or previous message',
      run: ({key}) => messages.step(key === 'e' ? 1 : -1)
    },
    {keys: ['/', 'g'], what: 'search the program, or go to a line', run: search},
    {
      keys: ['[', ']'],
      what: 'previous or next panel',
      run: ({key}) => tabs.step(key === ']' ? 1 : -1)
    },
  ];
}

function chartKeys({session, charts}: Parts): Shortcut[] {
  return [
    {
      keys: ['+', '=', '-', '0'],
      shown: '+ - 0',
      what: 'charts: zoom in, zoom out, show all',
      run: ({key}) =>
          (key === '0' ? session.setZoom(null) : session.zoomBy(key === '-' ? 2 : 0.5, session.row))
    },
    {keys: ['z'], what: 'charts: zoom to the chosen line', run: () => charts.zoomToSelection()},
    {
      keys: ['x'],
      what: 'charts: over time or over length',
      run: () => session.setAxis(session.axis === 'time' ? 'length' : 'time')
    },
  ];
}

function pictureKeys({session, path, surface}: Parts): Shortcut[] {
  return [
    {keys: ['c'], what: 'colour the path by the next quantity', run: () => path.nextQuantity()},
    {
      keys: ['2', '3'],
      what: 'path from above, or in space',
      run: ({key}) => path.setMode(key === '2' ? '2d' : '3d')
    },
    {
      keys: Object.keys(SIDES),
      what: 'path in space from the top, the front, the right, or isometric (with Shift)',
      run: ({key}) => path.lookFrom(SIDES[key]!)
    },
    {
      keys: ['f'],
      what: 'fit the path into the view',
      run: () => (session.tab === 'surface' ? surface.fit() : path.fit())
    },
  ];
}

function pageKeys({session, help}: Parts): Shortcut[] {
  return [
    {
      keys: ['a', 'b'],
      what: 'look at run A or B',
      run: ({key}) =>
          (key === 'a' || session.runs.length > 1) && session.setActive(key === 'a' ? 0 : 1)
    },
    {keys: ['t'], what: 'light or dark', run: () => session.setDark(!session.dark)},
    {keys: ['Escape'], shown: 'Esc', what: 'choose no line, show all', run: () => clear(session)},
    {keys: ['?'], what: 'this list', run: help},
  ];
}

function clear(session: Session): void {
  session.select(null);
  session.setLines(null);
  session.setZoom(null);
  session.setLimit(null);
  session.setTool(null);
}
