// SPDX-License-Identifier: MIT
// What gestures do to the picture of paths.

import type { Camera } from '../common/camera.ts';
import type { GestureTarget } from '../common/gestures.ts';
import type { Pointer } from './pointer.ts';

/** What a picture does when the camera has moved. */
export interface Steered {
  moved(): void;
  turned(): void;
  fit(): void;
}

/** Returns the gestures of a picture: a drag turns it in space, and moves it otherwise. */
export function steering(camera: Camera, pointer: Pointer, picture: Steered): GestureTarget {
  return {
    drag: (dx, dy) => {
      if (camera.mode === '2d') {
        camera.pan(dx, dy);
      } else {
        camera.rotate(dx, dy);
        picture.turned();
      }
      picture.moved();
    },
    pan: (dx, dy) => {
      camera.pan(dx, dy);
      picture.moved();
    },
    zoom: (factor, x, y) => {
      camera.zoomAt(factor, x, y);
      picture.moved();
    },
    fit: () => picture.fit(),
    click: (x, y, event) => pointer.click(x, y, event),
    hover: (place, event) => pointer.hover(place, event),
  };
}
