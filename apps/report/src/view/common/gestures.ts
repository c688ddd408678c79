// SPDX-License-Identifier: MIT
// Pointer, wheel and keys of a picture that can be moved, turned and zoomed.

/** What a picture does at gestures; places and distances are in CSS pixels. */
export interface GestureTarget {
  /** A drag with one pointer. */
  drag(dx: number, dy: number): void;
  /** A drag with Shift, the right button or two fingers. */
  pan(dx: number, dy: number): void;
  zoom(factor: number, x: number, y: number): void;
  fit(): void;
  /** A click without a drag. */
  click(x: number, y: number, event: PointerEvent): void;
  /** The pointer moves without a button; null where it leaves. */
  hover(place: [number, number] | null, event: PointerEvent): void;
}

const kClickSlack = 4; // CSS px that a pointer may move within a click.
const kKeyStep = 40;
const kKeyZoom = 1.25;

/** Connects an element's events with a picture; the result removes the connection. */
export function connectGestures(element: HTMLElement, target: GestureTarget): () => void {
  const stop = new AbortController();
  const options = { signal: stop.signal };
  const drags = new Drags(element, target);
  element.style.touchAction = 'none';
  element.addEventListener('pointerdown', (event) => drags.press(event), options);
  element.addEventListener('pointermove', (event) => drags.move(event), options);
  element.addEventListener('pointerup', (event) => drags.release(event, true), options);
  element.addEventListener('pointercancel', (event) => drags.release(event, false), options);
  element.addEventListener('pointerleave', (event) => target.hover(null, event), options);
  element.addEventListener('contextmenu', (event) => event.preventDefault(), options);
  element.addEventListener('dblclick', () => target.fit(), options);
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    target.zoom(factorOfWheel(event), ...placeOf(event, element));
  }, { ...options, passive: false });
  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (pressKey(event, element, target)) {
      event.preventDefault();
      event.stopPropagation();
    }
  }, options);
  return () => stop.abort();
}

/** Returns the place of the pointer from the element's corner. */
function placeOf(event: MouseEvent, element: HTMLElement): [number, number] {
  const box = element.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/** The pointers that are down on an element, and what they have done since the first came. */
class Drags {
  private readonly element: HTMLElement;
  private readonly target: GestureTarget;
  private readonly pointers = new Map<number, [number, number]>();
  private moved = 0; // CSS px, by all of them.
  private most = 0; // Pointers at once.

  constructor(element: HTMLElement, target: GestureTarget) {
    this.element = element;
    this.target = target;
  }

  press(event: PointerEvent): void {
    this.element.setPointerCapture(event.pointerId);
    if (this.pointers.size === 0) this.moved = this.most = 0;
    this.pointers.set(event.pointerId, placeOf(event, this.element));
    this.most = Math.max(this.most, this.pointers.size);
  }

  move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId);
    const [x, y] = placeOf(event, this.element);
    if (before === undefined) {
      if (event.buttons === 0) this.target.hover([x, y], event);
      return;
    }
    const dx = x - before[0], dy = y - before[1];
    this.moved += Math.hypot(dx, dy);
    const [mx, my, apart] = this.middle();
    this.pointers.set(event.pointerId, [x, y]);
    if (this.moved < kClickSlack) return;
    if (this.pointers.size >= 2) {
      const [nx, ny, next] = this.middle();
      this.target.pan(nx - mx, ny - my);
      if (apart > 10 && next > 10) this.target.zoom(next / apart, nx, ny);
    } else if (event.shiftKey || (event.buttons & 2) !== 0 || (event.buttons & 4) !== 0) {
      this.target.pan(dx, dy);
    } else {
      this.target.drag(dx, dy);
    }
  }

  release(event: PointerEvent, isClick: boolean): void {
    if (!this.pointers.delete(event.pointerId)) return;
    if (isClick && this.most === 1 && this.moved < kClickSlack && event.button === 0) {
      this.target.click(...placeOf(event, this.element), event);
    }
  }

  /** Returns the middle between the first two pointers, and how far they are apart. */
  private middle(): [number, number, number] {
    const all = [...this.pointers.values()];
    const [ax, ay] = all[0] ?? [0, 0], [bx, by] = all[1] ?? [ax, ay];
    return [(ax + bx) / 2, (ay + by) / 2, Math.hypot(bx - ax, by - ay)];
  }
}

/** Returns the factor by which a turn of the wheel zooms; a pinch comes as a turn with Ctrl. */
function factorOfWheel(event: WheelEvent): number {
  const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
  const speed = event.ctrlKey ? 0.01 : 0.0016;
  return Math.exp(-Math.max(-400, Math.min(400, pixels)) * speed);
}

function pressKey(event: KeyboardEvent, element: HTMLElement, target: GestureTarget): boolean {
  const move = event.shiftKey ? target.pan.bind(target) : target.drag.bind(target);
  const x = element.clientWidth / 2, y = element.clientHeight / 2;
  switch (event.key) {
    case 'ArrowLeft': move(kKeyStep, 0); return true;
    case 'ArrowRight': move(-kKeyStep, 0); return true;
    case 'ArrowUp': move(0, kKeyStep); return true;
    case 'ArrowDown': move(0, -kKeyStep); return true;
    case '+': case '=': target.zoom(kKeyZoom, x, y); return true;
    case '-': target.zoom(1 / kKeyZoom, x, y); return true;
    case '0': case 'f': target.fit(); return true;
    default: return false;
  }
}
