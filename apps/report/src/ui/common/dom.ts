// SPDX-License-Identifier: MIT
// Makes elements of the page.

export type Child = Node|string|null|undefined|false;
type Properties = Record<string, unknown>;

/**
 * Returns a new element. Properties that begin with `on` are listeners, `class`, `style`, `role`,
 * `aria-*` and `data-*` attributes, all others properties of the element; undefined ones are left
 * out.
 */
export function el<K extends keyof HTMLElementTagNameMap>(
    tag: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === null) continue;
    if (name.startsWith('on'))
      element.addEventListener(name.slice(2), value as EventListener);
    else if (/^(class|style|role|for|aria-.*|data-.*|colspan|scope)$/.test(name))
      element.setAttribute(name, String(value));
    else
      (element as unknown as Properties)[name] = value;
  }
  append(element, ...children);
  return element;
}

export function append(parent: Node, ...children: Child[]): void {
  for (const child of children)
    if (child)
      parent.appendChild(typeof child === 'string' ? document.createTextNode(child) : child);
}

/** Replaces all children of an element. */
export function fill(parent: Element, ...children: Child[]): void {
  parent.replaceChildren();
  append(parent, ...children);
}

/** Returns a small square of a colour, for legends. */
export function swatch(colour: string): HTMLElement {
  return el('span', {class: 'swatch', style: `background:${colour}`, 'aria-hidden': 'true'});
}

/** Returns a button that names what alone is shown, and ends that. */
export function chip(title: string, onclick: () => void, ...content: Child[]): HTMLElement {
  return el('button', {type: 'button', class: 'chip', title, onclick}, ...content);
}

/** Returns a drop-down of (value, label) pairs. */
export function select(
    label: string, options: Array<[string, string]>, value: string,
    change: (value: string) => void): HTMLSelectElement {
  const element = el('select', {'aria-label': label, title: label});
  for (const [key, text] of options) element.append(el('option', {value: key}, text));
  element.value = value;
  element.addEventListener('change', () => change(element.value));
  return element;
}

/** Returns a button that opens a menu, which a click elsewhere closes. */
export function drop(title: string, ...content: Child[]): HTMLElement {
  const element = el(
      'details', {class: 'drop'}, el('summary', {}, title), el('div', {class: 'menu'}, ...content));
  document.addEventListener('pointerdown', ({target}) => {
    if (!element.contains(target as Node)) element.open = false;
  });
  element.addEventListener('keydown', ({key}) => key === 'Escape' && (element.open = false));
  return element;
}

/** Returns a box to be ticked, with what follows it. */
export function checkbox(
    checked: boolean, change: (checked: boolean) => void, ...content: Child[]): HTMLElement {
  const box: HTMLInputElement =
      el('input', {type: 'checkbox', checked, onchange: () => change(box.checked)});
  return el('label', {}, box, ...content);
}

/** A group of buttons of which one is pressed. */
export class Choice {
  readonly element: HTMLElement;
  private readonly buttons = new Map<string, HTMLButtonElement>();

  constructor(
      label: string, options: Array<[string, string]>, value: string,
      change: (value: string) => void) {
    this.element = el('div', {class: 'choice', role: 'group', 'aria-label': label});
    for (const [key, text] of options) {
      const button = el('button', {type: 'button', onclick: () => change(key)}, text);
      this.buttons.set(key, button);
      this.element.append(button);
    }
    this.press(value);
  }

  press(value: string): void {
    for (const [key, button] of this.buttons)
      button.setAttribute('aria-pressed', String(key === value));
  }
}

/** A column of a table: its title, whether it holds numbers, and the cell of a row. */
export interface TableColumn<Row> {
  title: string;
  number?: boolean;
  cell: (row: Row) => Child;
}

/** Returns a table with a caption that only screen readers see. */
export function table<Row>(
    caption: string, columns: TableColumn<Row>[], rows: Row[],
    click?: (row: Row) => void): HTMLElement {
  const kind = (column: TableColumn<Row>) => (column.number ? 'number' : undefined);
  const head = el('tr');
  for (const column of columns)
    head.append(el('th', {scope: 'col', class: kind(column)}, column.title));
  const body = el('tbody');
  for (const row of rows) {
    const line = el('tr');
    columns.forEach((column, i) => {
      const content = column.cell(row);
      line.append(
          el('td', {class: kind(column)},
             i === 0 && click ?
                 el('button', {type: 'button', class: 'link', onclick: () => click(row)}, content) :
                 content));
    });
    body.append(line);
  }
  const made =
      el('table', {}, el('caption', {class: 'unseen'}, caption), el('thead', {}, head), body);
  return el('div', {class: 'scroll-x'}, made);
}
