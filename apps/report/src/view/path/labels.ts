// SPDX-License-Identifier: MIT
// Texts in a picture, none of which covers another.

import { css, type Theme } from '../common/theme.ts';

export const kFont = '11px system-ui, sans-serif';
export const kBold = '600 12px system-ui, sans-serif';
const kHeight = 14; // CSS px.
const kSpace = 3;

interface Rectangle {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Writes text with an edge of the background's colour, to be read above lines. */
export function outlined(c: CanvasRenderingContext2D, text: string, x: number, y: number,
  theme: Theme): void {
  c.save();
  c.strokeStyle = css(theme.background, 0.9);
  c.lineWidth = 4;
  c.lineJoin = 'round';
  c.strokeText(text, x, y);
  c.restore();
  c.fillText(text, x, y);
}

/** The texts of a frame; a text that finds no free place in `area` is left out. */
export class Labels {
  private readonly c: CanvasRenderingContext2D;
  private readonly theme: Theme;
  private readonly area: Rectangle;
  private readonly taken: Rectangle[] = [];

  constructor(c: CanvasRenderingContext2D, theme: Theme, area: Rectangle) {
    this.c = c;
    this.theme = theme;
    this.area = area;
  }

  /** Writes a text beside a point, `away` CSS pixels from it, where it is free. */
  write(text: string, x: number, y: number, away: number): void {
    const { c } = this;
    if (x < this.area.left || x > this.area.right || y < this.area.top || y > this.area.bottom) return;
    c.font = kFont;
    const width = c.measureText(text).width;
    for (const [dx, dy] of [[1, -1], [1, 1], [-1, -1], [-1, 1]] as const) {
      const left = dx > 0 ? x + away : x - away - width;
      const top = dy > 0 ? y + away : y - away - kHeight;
      const place = { left, top, right: left + width, bottom: top + kHeight };
      if (!this.isFree(place)) continue;
      this.taken.push(place);
      c.fillStyle = css(this.theme.ink);
      c.textAlign = 'left';
      c.textBaseline = 'middle';
      outlined(c, text, left, top + kHeight / 2, this.theme);
      return;
    }
  }

  private isFree({ left, top, right, bottom }: Rectangle): boolean {
    const { area } = this;
    return left >= area.left && right <= area.right && top >= area.top && bottom <= area.bottom &&
      this.taken.every((other) => left > other.right + kSpace || right < other.left - kSpace ||
        top > other.bottom || bottom < other.top);
  }
}
