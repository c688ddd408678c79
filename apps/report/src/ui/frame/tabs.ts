// SPDX-License-Identifier: MIT
// Panels of which one is shown, chosen by tabs.
import {el} from '../common/dom.ts';
import type {Session, TabId} from '../common/session.ts';

export interface Tab {
  id: TabId;
  title: string;
  badge?: string;
  panel: HTMLElement;
}

export class Tabs {
  readonly element: HTMLElement;
  private readonly session: Session;
  private readonly tabs: Tab[];
  private readonly buttons: HTMLButtonElement[];

  constructor(session: Session, tabs: Tab[]) {
    this.session = session;
    this.tabs = tabs;
    this.buttons = tabs.map(
        ({id, title, badge}) =>
            el('button', {
              type: 'button',
              role: 'tab',
              id: `tab-${id}`,
              'aria-controls': `panel-${id}`,
              onclick: () => session.show(id),
            },
               title, badge ? el('span', {class: 'badge'}, badge) : null));
    for (const {id, panel} of tabs) {
      panel.id = `panel-${id}`;
      panel.setAttribute('role', 'tabpanel');
      panel.setAttribute('aria-labelledby', `tab-${id}`);
    }
    const list =
        el('div', {
          class: 'tabs',
          role: 'tablist',
          'aria-label': 'Panels',
          onkeydown: (event: KeyboardEvent) => this.key(event)
        },
           ...this.buttons);
    this.element =
        el('aside', {class: 'side'}, list,
           el('div', {class: 'panels'}, ...tabs.map(({panel}) => panel)));
    session.on(['tab'], () => this.mark());
    this.mark();
  }

  /** Shows the next or the previous panel. */
  step(by: 1|- 1): void {
    const now = this.tabs.findIndex(({id}) => id === this.session.tab);
    this.session.show(this.tabs[(now + by + this.tabs.length) % this.tabs.length]!.id);
  }

  private mark(): void {
    this.tabs.forEach(({id, panel}, i) => {
      const shown = id === this.session.tab;
      panel.hidden = !shown;
      this.buttons[i]!.setAttribute('aria-selected', String(shown));
      this.buttons[i]!.tabIndex = shown ? 0 : -1;
    });
  }

  private key(event: KeyboardEvent): void {
    const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    this.step(by);
    this.buttons[this.tabs.findIndex(({id}) => id === this.session.tab)]!.focus();
  }
}
