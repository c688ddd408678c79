// SPDX-License-Identifier: MIT
// The orthographic camera of the view of a path.

export type Vector = [number, number, number];

/** A box: lowest and highest coordinates, in mm from the centre of the picture's paths. */
export interface Box {
  low: Vector;
  high: Vector;
}

/** Space at the edges that a fitted picture leaves free, in CSS pixels. */
export interface Insets {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Directions of the screen in space: right, up and towards the viewer; each of length 1. */
export interface Basis {
  right: Vector;
  up: Vector;
  towards: Vector;
}

/** A direction that a picture in space is looked at from; `isometric` is from the front right. */
export type Side = 'top' | 'front' | 'right' | 'isometric';

/** Where the viewer is: turned about z, and above the horizon; in radians. */
interface Direction {
  yaw: number;
  elevation: number;
}

const kSides: Record<Side, Direction> = {
  top: { yaw: 0, elevation: Math.PI / 2 },
  front: { yaw: 0, elevation: 0 },
  right: { yaw: Math.PI / 2, elevation: 0 },
  isometric: { yaw: Math.PI / 4, elevation: Math.atan(Math.SQRT1_2) },
};

const kLargestScale = 2e4; // CSS px per mm: float32 positions show their steps beyond it.
const kSmallestScale = 1e-5;

/** Returns sine and cosine; those of right angles are exact, so that a face is seen as a line. */
function sineAndCosine(angle: number): [number, number] {
  const exact = (value: number): number => (Math.abs(value) < 1e-12 ? 0 : value);
  return [exact(Math.sin(angle)), exact(Math.cos(angle))];
}

function dot(a: Vector, x: number, y: number, z: number): number {
  return a[0] * x + a[1] * y + a[2] * z;
}

/** An orthographic camera; `scale` is in CSS pixels per mm. */
export class Camera {
  mode: '2d' | '3d' = '2d';
  scale = 1;
  width = 1;
  height = 1;
  target: Vector = [0, 0, 0];
  private direction: Direction = { yaw: 0.6, elevation: 0.6 };

  /** Returns the directions of the screen: from above in 2-D, turned by the user in 3-D. */
  basis(): Basis {
    const { yaw, elevation } = this.mode === '2d' ? kSides.top : this.direction;
    const [s, c] = sineAndCosine(yaw), [se, ce] = sineAndCosine(elevation);
    return { right: [c, s, 0], up: [-s * se, c * se, ce], towards: [s * ce, -c * ce, se] };
  }

  /** Returns the place of a point on the screen, in CSS pixels from the top left corner. */
  project(x: number, y: number, z: number): [number, number] {
    const { right, up } = this.basis();
    const t = this.target;
    const dx = x - t[0], dy = y - t[1], dz = z - t[2];
    return [
      this.width / 2 + dot(right, dx, dy, dz) * this.scale,
      this.height / 2 - dot(up, dx, dy, dz) * this.scale,
    ];
  }

  /** Moves the picture by this many CSS pixels. */
  pan(dx: number, dy: number): void {
    const { right, up } = this.basis();
    for (let k = 0; k < 3; k++) {
      this.target[k]! += (-dx * right[k]! + dy * up[k]!) / this.scale;
    }
  }

  /** Looks at the picture in space from a side. */
  lookFrom(side: Side): void {
    this.mode = '3d';
    this.direction = { ...kSides[side] };
  }

  /** Turns the picture as if its front were dragged by this many CSS pixels. */
  rotate(dx: number, dy: number): void {
    const { yaw, elevation } = this.direction;
    const highest = Math.PI / 2;
    this.direction = {
      yaw: yaw - dx * 0.008,
      elevation: Math.min(highest, Math.max(-highest, elevation + dy * 0.008)),
    };
  }

  /** Changes the scale by a factor; the point at this place of the screen stays there. */
  zoomAt(factor: number, px: number, py: number): void {
    const next = Math.min(kLargestScale, Math.max(kSmallestScale, this.scale * factor));
    const dx = px - this.width / 2, dy = py - this.height / 2;
    const ratio = next / this.scale;
    this.scale = next;
    this.pan(dx * (1 - ratio), dy * (1 - ratio));
  }

  /** Shows the box as large as it fits between the insets. */
  fit(box: Box, insets: Insets): void {
    const { right, up } = this.basis();
    let spanX = 0, spanY = 0;
    for (let k = 0; k < 3; k++) {
      const size = box.high[k]! - box.low[k]!;
      spanX += Math.abs(right[k]!) * size;
      spanY += Math.abs(up[k]!) * size;
      this.target[k] = (box.low[k]! + box.high[k]!) / 2;
    }
    const freeWidth = Math.max(20, this.width - insets.left - insets.right);
    const freeHeight = Math.max(20, this.height - insets.top - insets.bottom);
    const scale = Math.min(freeWidth / Math.max(1e-3, spanX), freeHeight / Math.max(1e-3, spanY));
    this.scale = Math.min(kLargestScale, Math.max(kSmallestScale, scale));
    this.pan((insets.left - insets.right) / 2, (insets.top - insets.bottom) / 2);
  }
}
