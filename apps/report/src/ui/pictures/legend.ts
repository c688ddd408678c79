// SPDX-License-Identifier: MIT
// The scale of the colours of the path.
import {el, swatch} from '../common/dom.ts';
import {fixed, significant} from '../common/numbers.ts';
import {cssOf, neutral, salience} from '../common/palette.ts';
import {categoriesOf, isCategory, type Quantity} from '../common/quantities.ts';
import type {Session} from '../common/session.ts';

/** Returns the legend of a quantity whose colours go over `scale`. */
export function legend(session: Session, quantity: Quantity, scale: [number, number]): HTMLElement {
  const unit = quantity.unit ? `, ${quantity.unit}` : '';
  const title = el('div', {class: 'legend-title'}, quantity.label + unit);
  if (isCategory(quantity.id)) {
    const list = el('ul');
    for (const {name, colour} of categoriesOf(session.runs, quantity.id))
      list.append(el('li', {}, swatch(colour), name));
    if (quantity.id !== 'run')
      list.append(el('li', {}, swatch(cssOf(neutral(session.dark))), 'rapid'));
    return el('div', {class: 'legend-row'}, title, list, common(session, quantity));
  }
  const reversed = quantity.id === 'ratio';
  const stops = Array.from(
      {length: 11},
      (_, i) => `${cssOf(salience(reversed ? 1 - i / 10 : i / 10, session.dark))} ${10 * i}%`);
  const [low, high] = scale;
  const tick = (part: number) => {
    const value = low + part * (high - low);
    return el('span', {}, high >= 100 ? fixed(value, 0) : significant(value, 2));
  };
  return el(
      'div', {class: 'legend-row'}, title,
      el('div', {class: 'scale'}, tick(0),
         el('div', {class: 'ramp', style: `background:linear-gradient(90deg,${stops.join(',')})`}),
         tick(1)),
      el('div', {class: 'none'}, swatch(cssOf(neutral(session.dark))),
         quantity.id === 'ratio' ? 'rapid or at rest' : 'rapid, or no value'),
      common(session, quantity));
}

/** States that the colours of two runs can be compared. */
function common({runs}: Session, {id}: Quantity): HTMLElement|null {
  if (runs.length < 2 || id === 'run') return null;
  return el('div', {class: 'none'}, isCategory(id) ? 'same in A and B' : 'same scale for A and B');
}
