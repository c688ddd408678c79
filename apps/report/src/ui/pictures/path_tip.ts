// SPDX-License-Identifier: MIT
// The description of the place of a path that the pointer is at.
import type {RunModel} from '../../data/run_model.ts';
import {el, swatch} from '../common/dom.ts';
import {limitColour, limitName} from '../common/limits.ts';
import * as numbers from '../common/numbers.ts';

const ERRORS = [
  ['contour error', 'contour_um'],
  ['deviation', 'deviation_um'],
  ['chord error', 'chord_error_um'],
  ['Rmax', 'rmax_um'],
] as const;

/** Returns what is known of a row of a run; `letter` names the run, and is empty if it is alone. */
export function tipLines(run: RunModel, letter: string, row: number): HTMLElement[] {
  const node = run.nodeAt(row);
  const place = run.placeAt(row);
  const limit = run.data.limits[run.column('limit')[node]!] ?? '';
  const programmed = run.column('feed')[node]!;
  const v = run.valueAt('v', row);
  const line = (...children: Array<Node|string>) => el('div', {}, ...children);
  const known = ERRORS.filter(([, name]) => run.has(name) && run.column(name)[node]! >= 0);
  return [
    line(
        el('b', {},
           `${letter ? `${letter}, ` : ''}line ${place ? numbers.count(place.line) : '–'}`),
        ` at ${numbers.instant(run.secondsAt(row))}`),
    line(
        programmed > 0 ? `${numbers.feedNumber(v)} of ${numbers.feed(programmed)}` :
                         numbers.feed(v)),
    line(swatch(limitColour(limit)), limitName(limit)),
    ...known.map(
        ([label, name]) => line(`${label} ${numbers.withUnit(run.column(name)[node]!, 'µm')}`)),
  ];
}

/** Puts the description beside the pointer, on the side where the picture has more space. */
export function placeTip(tip: HTMLElement, event: PointerEvent, box: DOMRect): void {
  const right = event.clientX - box.left > box.width / 2;
  tip.style.left = right ? 'auto' : `${event.clientX - box.left + 14}px`;
  tip.style.right = right ? `${box.right - event.clientX + 14}px` : 'auto';
  const below = event.clientY - box.top > box.height / 2;
  tip.style.top = below ? 'auto' : `${event.clientY - box.top + 10}px`;
  tip.style.bottom = below ? `${box.bottom - event.clientY + 10}px` : 'auto';
}
