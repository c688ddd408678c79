// SPDX-License-Identifier: MIT
// Colour maps whose order is seen by all, also in grey.

import type { Rgb } from '../common/theme.ts';

// Cividis (Nunez, Anderton and Renslow, 2018) and viridis (van der Walt and Smith, 2015) at equal
// distances.
const kCividis: Rgb[] = [[0, 34, 78], [18, 53, 112], [59, 73, 108], [87, 93, 109], [112, 113, 115],
  [138, 134, 120], [165, 156, 116], [195, 179, 105], [225, 204, 85], [254, 232, 56]];
const kViridis: Rgb[] = [[68, 1, 84], [72, 40, 120], [62, 73, 137], [49, 104, 142], [38, 130, 142],
  [31, 158, 137], [53, 183, 121], [110, 206, 88], [181, 222, 43], [253, 231, 37]];

function interpolate(stops: Rgb[], value: number): Rgb {
  const place = Math.min(1, Math.max(0, value)) * (stops.length - 1);
  const low = Math.min(stops.length - 2, Math.floor(place)), part = place - low;
  const a = stops[low]!, b = stops[low + 1]!;
  return [0, 1, 2].map((k) => a[k]! + (b[k]! - a[k]!) * part) as Rgb;
}

/** Returns the colour of a height from 0 (lowest) to 1 (highest). */
export function heightColour(value: number): Rgb {
  return interpolate(kCividis, value);
}

/** Returns the colour of a roughness from 0 to 1 (largest). */
export function roughnessColour(value: number): Rgb {
  return interpolate(kViridis, value);
}

/** Colours of regions that meet their target, miss it, or have none (Okabe and Ito, 2008). */
export const kMet: Rgb = [86, 180, 233];
export const kMissed: Rgb = [213, 94, 0];
export const kNoTarget: Rgb = [150, 156, 164];
