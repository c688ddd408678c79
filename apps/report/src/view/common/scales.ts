// SPDX-License-Identifier: MIT
// Steps and labels of rulers and scales.

/** Returns the smallest of 1, 2, 5 times a power of ten that is at least `least`. */
export function niceStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  for (const factor of [1, 2, 5]) if (factor * power >= least * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

/** Returns a number with the digits that steps of this size need, with a true minus sign. */
export function label(value: number, step: number): string {
  const digits = Math.min(9, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  const text = (Math.abs(value) < step * 1e-6 ? 0 : value).toFixed(digits);
  return text.replace('-', '\u2212');
}

/** Returns a length in mm with three or four digits, without zeros at its end. */
export function lengthText(mm: number): string {
  const size = Math.abs(mm);
  const digits = size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 0.1 ? 3 : 5;
  return String(Number(mm.toFixed(digits))).replace('-', '\u2212');
}

/** Returns a number with this many digits after the point, with a true minus sign. */
export function fixed(value: number, digits: number): string {
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? (0).toFixed(digits) : text).replace('-', '\u2212');
}
