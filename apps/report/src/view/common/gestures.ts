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
  const pointers = new Map<number, [number, number]>();
  let moved = 0, most = 0;
  const place = (event: MouseEvent): [number, number] => {
    const box = element.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const middle = (): [number, number, number] => {
    const all = [...pointers.values()];
    const [ax, ay] = all[0] ?? [0, 0], [bx, by] = all[1] ?? [ax, ay];
    return [(ax + bx) / 2, (ay + by) / 2, Math.hypot(bx - ax, by - ay)];
  };

  element.style.touchAction = 'none';
  element.addEventListener('pointerdown', (event) => {
    element.setPointerCapture(event.pointerId);
    if (pointers.size === 0) moved = most = 0;
    pointers.set(event.pointerId, place(event));
    most = Math.max(most, pointers.size);
  }, options);
  element.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (before === undefined) {
      if (event.buttons === 0) target.hover(place(event), event);
      return;
    }
    const [x, y] = place(event);
    const dx = x - before[0], dy = y - before[1];
    moved += Math.hypot(dx, dy);
    const [mx, my, apart] = middle();
    pointers.set(event.pointerId, [x, y]);
    if (moved < kClickSlack) return;
    if (pointers.size >= 2) {
      const [nx, ny, next] = middle();
      target.pan(nx - mx, ny - my);
      if (apart > 10 && next > 10) target.zoom(next / apart, nx, ny);
    } else if (event.shiftKey || (event.buttons & 2) !== 0 || (event.buttons & 4) !== 0) {
      target.pan(dx, dy);
    } else {
      target.drag(dx, dy);
    }
  }, options);
  const release = (event: PointerEvent, isClick: boolean): void => {
    if (!pointers.delete(event.pointerId)) return;
    if (isClick && most === 1 && moved < kClickSlack && event.button === 0) {
      target.click(...place(event), event);
    }
  };
  element.addEventListener('pointerup', (event) => release(event, true), options);
  element.addEventListener('pointercancel', (event) => release(event, false), options);
  element.addEventListener('pointerleave', (event) => target.hover(null, event), options);
  element.addEventListener('contextmenu', (event) => event.preventDefault(), options);
  element.addEventListener('dblclick', () => target.fit(), options);
  element.addEventListener('wheel', (event) => {
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1);
    const speed = event.ctrlKey ? 0.01 : 0.0016;
    target.zoom(Math.exp(-Math.max(-400, Math.min(400, pixels)) * speed), ...place(event));
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
