// SPDX-License-Identifier: MIT
// What the picture of the path shows beside the path, and the menu of it.
import {extentOf, leavesTravel, travelEdges, travelOf} from '../../data/travel.ts';
import type {Outline} from '../../view/levels/path_types.ts';
import {checkbox, drop, el} from '../common/dom.ts';
import type {Session} from '../common/session.ts';

type LayerId = 'travel';

/** An outline of a run, with its number. */
interface Drawn extends Outline {
  run: number;
}

export class Layers {
  /** The menu, or null where there is nothing to choose. */
  readonly element: HTMLElement|null;
  private readonly session: Session;
  private readonly travel: Drawn[];
  private readonly on = new Set<LayerId>();

  /** Calls `changed` when something else is to be shown. */
  constructor(session: Session, changed: () => void) {
    this.session = session;
    this.travel = travels(session);
    if (session.runs.some(leavesTravel)) this.on.add('travel');
    const box = (id: LayerId, text: string) => checkbox(this.on.has(id), (checked) => {
      if (checked)
        this.on.add(id);
      else
        this.on.delete(id);
      changed();
    }, el('span', {class: `sample ${id}`, 'aria-hidden': 'true'}), text);
    const boxes = [this.travel.length > 0 && box('travel', 'Travel of the machine')];
    this.element = boxes.some(Boolean) ? drop('Layers', ...boxes) : null;
  }

  /** The outlines that are shown. */
  outlines(): Outline[] {
    return this.on.has('travel') ? named(this.session, this.travel) : [];
  }
}

function travels({runs}: Session): Drawn[] {
  return runs.flatMap((run, index) => {
    const travel = travelOf(run.data.axis_limits);
    const extent = extentOf(run);
    if (!travel || !extent) return [];
    return [{run: index, name: 'travel', look: 'travel', edges: travelEdges(travel, extent)}];
  });
}

/** The outlines of the runs that are shown; one that both runs have is drawn once. */
function named({shown}: Session, all: Drawn[]): Outline[] {
  const drawn = all.filter(({run}) => shown[run]);
  const twin = (one: Drawn) => drawn.find(
      (other) => other.run !== one.run && other.name === one.name &&
          other.edges.join() === one.edges.join());
  const several = drawn.some(({run}) => run !== drawn[0]!.run);
  return drawn.filter((one) => (twin(one)?.run ?? one.run) >= one.run)
      .map((one) => (!several || twin(one) ? one : {...one, name: `${one.name} ${'AB'[one.run]}`}));
}
