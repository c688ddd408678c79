// SPDX-License-Identifier: MIT
// The menu of what the picture of the path shows beside the path.
import {leavesTravel} from '../../data/travel.ts';
import type {Scenery} from '../../view/levels/path_types.ts';
import {checkbox, type Child, drop, el} from '../common/dom.ts';
import * as numbers from '../common/numbers.ts';
import type {Session} from '../common/session.ts';
import {namedOutlines, originsOf, travelsOf, workpiecesOf, type RunOutline} from './scenery.ts';

const MOST_LINKS = 8;  // to lines that state workpieces

type LayerId = 'travel'|'workpiece'|'origins';

export class Layers {
  /** The menu, or null where there is nothing to choose. */
  readonly element: HTMLElement|null;
  private readonly session: Session;
  private readonly travels: RunOutline[];
  private readonly workpieces: RunOutline[];
  private readonly on = new Set<LayerId>(['workpiece', 'origins']);

  /** Calls `changed` when something else is to be shown; `fits` where a fit takes it in. */
  constructor(session: Session, changed: (fits: boolean) => void) {
    this.session = session;
    this.travels = travelsOf(session.runs);
    this.workpieces = workpiecesOf(session.runs);
    if (session.runs.some(leavesTravel)) this.on.add('travel');
    const boxes = [
      this.travels.length > 0 && this.box('travel', 'Travel of the machine', changed),
      this.workpieces.length > 0 && this.box('workpiece', 'Workpiece', changed),
      ...this.links(),
      session.runs.some(({data}) => data.origins?.length) &&
          this.box('origins', 'Work systems', changed),
    ];
    this.element = boxes.some(Boolean) ? drop('Layers', ...boxes) : null;
  }

  /** What is shown. */
  scenery(): Scenery {
    const {on, session: {runs, shown}} = this;
    return {
      outlines: [
        ...namedOutlines(on.has('travel') ? this.travels : [], shown),
        ...namedOutlines(on.has('workpiece') ? this.workpieces : [], shown)
      ],
      origins: on.has('origins') ? originsOf(runs, shown) : [],
    };
  }

  private box(id: LayerId, text: string, changed: (fits: boolean) => void): HTMLElement {
    const change = (checked: boolean) => {
      if (checked)
        this.on.add(id);
      else
        this.on.delete(id);
      changed(id !== 'origins');
    };
    return checkbox(
        this.on.has(id), change, el('span', {class: `sample ${id}`, 'aria-hidden': 'true'}), text);
  }

  /** Buttons that lead to the lines that state the workpieces. */
  private links(): Child[] {
    const {session} = this;
    return this.workpieces.filter(({line}) => line > 0)
        .slice(0, MOST_LINKS)
        .map(({run, name, file, line}) => el('button', {
               type: 'button',
               class: 'link',
               onclick: () => {
                 if (session.active !== run) session.setActive(run);
                 session.select({file, line});
               }
             },
                 `${name}, line ${numbers.count(line)}`));
  }
}
