// SPDX-License-Identifier: MIT
// Colours of the view of a path in light and dark.

export type Rgb = [number, number, number];

export interface Theme {
  background: Rgb;
  ink: Rgb;
  /** Secondary text and lines, at least 4.5 : 1 against the background. */
  quiet: Rgb;
  grid: Rgb;
  rapid: Rgb;
  workpiece: Rgb;
  /** Inner and outer colour of highlighted stretches and of the tool's marker. */
  highlight: Rgb;
  casing: Rgb;
}

export const kLight: Theme = {
  background: [255, 255, 255],
  ink: [24, 28, 33],
  quiet: [84, 92, 102],
  grid: [222, 226, 231],
  rapid: [132, 140, 150],
  workpiece: [140, 100, 40],
  highlight: [255, 45, 155],
  casing: [16, 18, 22],
};

export const kDark: Theme = {
  background: [21, 24, 29],
  ink: [236, 239, 243],
  quiet: [166, 174, 184],
  grid: [52, 58, 66],
  rapid: [122, 131, 142],
  workpiece: [208, 170, 110],
  highlight: [255, 74, 170],
  casing: [255, 255, 255],
};

/** Returns a colour as CSS takes it. */
export function css(colour: Rgb, alpha = 1): string {
  return `rgba(${colour[0]},${colour[1]},${colour[2]},${alpha})`;
}

/** Returns the theme with the background of the element, where that has an opaque one. */
export function themeOf(dark: boolean, element: Element): Theme {
  const theme = { ...(dark ? kDark : kLight) };
  for (let at: Element | null = element; at !== null; at = at.parentElement) {
    const found = /^rgb\((\d+), (\d+), (\d+)\)$/.exec(getComputedStyle(at).backgroundColor);
    if (found === null) continue;
    theme.background = [Number(found[1]), Number(found[2]), Number(found[3])];
    break;
  }
  return theme;
}
