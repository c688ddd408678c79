// SPDX-License-Identifier: MIT
// What keys do, and the list of them.
import {el} from '../common/dom.ts';

const HINT =
    'In the charts: drag to zoom, click to choose a line, double-click to show all, Shift and ' +
    'wheel to zoom. In the view: drag to turn or move, wheel to zoom, click to choose a line. ' +
    'In the program: Shift and click, or Shift and arrows, to show a range of lines alone.';

export interface Shortcut {
  keys: string[];  // as KeyboardEvent.key has them
  shown?: string;  // how the list writes them
  what: string;
  run: (event: KeyboardEvent) => void;
}

/** Runs shortcuts, except where text is typed or a control uses the key itself. */
export function listen(shortcuts: Shortcut[]): void {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const target = event.target as HTMLElement;
    if (target.closest('dialog') || /^(textarea|select)$/i.test(target.tagName)) return;
    if (target instanceof HTMLInputElement &&
        (target.type !== 'range' || event.key.startsWith('Arrow'))) {
      if (target.type !== 'checkbox' || event.key === ' ') return;
    }
    if (event.key === ' ' && target.closest('button, summary')) return;
    const shortcut = shortcuts.find(({keys}) => keys.includes(event.key));
    if (!shortcut) return;
    event.preventDefault();
    shortcut.run(event);
  });
}

/** Returns the dialog that lists the shortcuts. */
export function shortcutDialog(shortcuts: Shortcut[]): HTMLDialogElement {
  const list = el('dl', {class: 'keys'});
  for (const {keys, shown, what} of shortcuts) {
    const names = el('dt');
    for (const key of (shown ?? keys.join(' ')).split(' ')) names.append(el('kbd', {}, key), ' ');
    list.append(names, el('dd', {}, what));
  }
  const dialog: HTMLDialogElement = el(
      'dialog', {'aria-label': 'Keys'}, el('h2', {}, 'Keys'), list, el('p', {class: 'facts'}, HINT),
      el('form', {method: 'dialog'}, el('button', {}, 'Close')));
  return dialog;
}
