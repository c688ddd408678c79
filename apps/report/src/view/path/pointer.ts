// SPDX-License-Identifier: MIT
// Finds what of the paths the pointer is at, and reports it to listeners.

import type { HitListener, PathHit } from '../levels/path_types.ts';

/** The pointer over a picture; hovering is looked up once per frame. */
export class Pointer {
  onPick: HitListener | null = null;
  onHover: HitListener | null = null;
  private readonly element: HTMLElement;
  private readonly find: (x: number, y: number) => PathHit | null;
  private waiting: (() => void) | null = null;

  /** `find` returns the place of a path that is drawn at a place in CSS pixels, or null. */
  constructor(element: HTMLElement, find: (x: number, y: number) => PathHit | null) {
    this.element = element;
    this.find = find;
  }

  click(x: number, y: number, event: PointerEvent): void {
    this.onPick?.(this.find(x, y), event);
  }

  hover(place: [number, number] | null, event: PointerEvent): void {
    if (this.onHover === null) return;
    const isWaiting = this.waiting !== null;
    this.waiting = () => {
      const hit = place === null ? null : this.find(...place);
      this.element.style.cursor = hit === null ? 'default' : 'pointer';
      this.onHover?.(hit, event);
    };
    if (isWaiting) return;
    requestAnimationFrame(() => {
      const call = this.waiting;
      this.waiting = null;
      call?.();
    });
  }
}
