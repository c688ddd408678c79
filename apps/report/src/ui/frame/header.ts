// SPDX-License-Identifier: MIT
// The bar above the page: what was run, which run is looked at, and the look of the page.
import {Choice, el} from '../common/dom.ts';
import type {Session} from '../common/session.ts';
import {statusText} from '../common/status.ts';

/** Returns the bar; `help` opens the list of keys. */
export function header(session: Session, help: () => void): HTMLElement {
  const title = el('h1');
  const status = el('span');
  const draw = () => {
    const {program, machine} = session.run.data;
    status.className = `status ${session.run.data.status}`;
    status.textContent = session.run.data.status === 'done' ? '' : statusText(session.run.data);
    title.replaceChildren(
        el('b', {title: program}, program.split(/[\\/]/).pop() ?? ''),
        el('span', {}, machine ? ` on ${machine}` : ''));
    document.title = `${program.split(/[\\/]/).pop()} - softcnc report`;
  };
  session.on(['run'], draw);
  draw();
  return el(
      'header', {}, el('span', {class: 'brand'}, 'softcnc'), title, status,
      session.runs.length > 1 && runs(session),
      el('button', {
        type: 'button',
        class: 'icon',
        title: 'Light or dark (t)',
        'aria-label': 'Light or dark',
        onclick: () => session.setDark(!session.dark)
      },
         '◐'),
      el('button', {type: 'button', onclick: () => window.print()}, 'Print'),
      el('button',
         {type: 'button', class: 'icon', title: 'Keys (?)', 'aria-label': 'Keys', onclick: help},
         '?'));
}

function runs(session: Session): HTMLElement {
  const choice = new Choice(
      'Run that is looked at', [['0', 'A'], ['1', 'B']], String(session.active),
      (run) => session.setActive(Number(run)));
  session.on(['run'], () => choice.press(String(session.active)));
  return choice.element;
}
