// SPDX-License-Identifier: MIT
// Colours of values between 0 and 1 and of categories, for light and dark pages.

export type Rgb = [number, number, number];

// Viridis (van der Walt and Smith, 2015) at equal distances: its lightness rises evenly, so that
// the order survives colour blindness and printing in grey.
const VIRIDIS = [
  '#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b',
  '#fde725'
].map(rgbOf);

// What is unremarkable lies near the background, what is remarkable far from it.
const LIGHT_RANGE: [number, number] = [0.76, 0];
const DARK_RANGE: [number, number] = [0.37, 1];

const CATEGORIES =
    ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#f0e442', '#8c8c8c'];

export function rgbOf(hex: string): Rgb {
  const value = parseInt(hex.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

export function cssOf([r, g, b]: Rgb): string {
  return `rgb(${r},${g},${b})`;
}

/** The colour of a place in a list, for tools and runs. */
export function categoryColour(index: number): string {
  return CATEGORIES[index % CATEGORIES.length]!;
}

/** What has no value: rapids, and nodes that a measure does not know. */
export function neutral(dark: boolean): Rgb {
  return dark ? [92, 98, 108] : [186, 191, 198];
}

/** What a filter leaves out: near the background. */
export function dimmed(dark: boolean): Rgb {
  return dark ? [44, 49, 57] : [224, 227, 231];
}

/** Returns the colour of a value from 0 (unremarkable) to 1 (remarkable). */
export function salience(value: number, dark: boolean): Rgb {
  const [calm, loud] = dark ? DARK_RANGE : LIGHT_RANGE;
  const place = (calm + (loud - calm) * Math.min(Math.max(value, 0), 1)) * (VIRIDIS.length - 1);
  const low = Math.min(Math.floor(place), VIRIDIS.length - 2);
  const part = place - low;
  return [
    0, 1, 2
  ].map((i) => Math.round(VIRIDIS[low]![i]! * (1 - part) + VIRIDIS[low + 1]![i]! * part)) as Rgb;
}

/** Returns 256 colours from 0 to 1, three bytes each. */
export function salienceTable(dark: boolean): Uint8Array {
  const table = new Uint8Array(3 * 256);
  for (let i = 0; i < 256; ++i) table.set(salience(i / 255, dark), 3 * i);
  return table;
}
