// SPDX-License-Identifier: MIT
// Numbers as people read them, with their units.

const THIN = '\u202f';  // narrow space that does not break

/** Returns a number with `digits` decimals and groups of thousands. */
export function fixed(value: number, digits: number): string {
  const text = Math.abs(value).toFixed(digits);
  const [whole = '', part] = text.split('.');
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, ',') : whole;
  const zero = /^[0.]*$/.test(text);
  return (value < 0 && !zero ? '\u2212' : '') + grouped + (part ? '.' + part : '');
}

/** Returns a number with about `digits` significant digits, at most six decimals. */
export function significant(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -6) return value.toExponential(digits - 1).replace('-', '\u2212');
  return fixed(value, Math.min(Math.max(digits - 1 - size, 0), 9));
}

/** Returns a number with at most `digits` significant digits and no zeros at its end. */
export function plain(value: number, digits = 4): string {
  return significant(value, digits).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '');
}

export const count = (value: number): string => fixed(value, 0);

/** Returns seconds as 0.123 s, 12.3 s, 1 min 23.4 s or 2 h 03 min. */
export function time(seconds: number): string {
  const sign = seconds < 0 ? '\u2212' : '';
  const s = Math.abs(seconds);
  if (s < 0.0005) return `0${THIN}s`;
  if (s < 9.9995) return `${sign}${s.toFixed(s < 0.9995 ? 3 : 2)}${THIN}s`;
  if (s < 59.95) return `${sign}${s.toFixed(1)}${THIN}s`;
  if (s < 3599.5) {
    const tenths = Math.round(s * 10);
    const rest = ((tenths % 600) / 10).toFixed(1).padStart(4, '0');
    return `${sign}${Math.floor(tenths / 600)}${THIN}min ${rest}${THIN}s`;
  }
  const minutes = Math.round(s / 60);
  return `${sign}${Math.floor(minutes / 60)}${THIN}h ${String(minutes % 60).padStart(2, '0')}${
      THIN}min`;
}

/** Returns the time of a line, which often takes milliseconds only. */
export function lineTime(seconds: number): string {
  return seconds < 0.9995 ? `${fixed(seconds * 1e3, 1)}${THIN}ms` : time(seconds);
}

/** Returns a difference of times with its sign. */
export function timeChange(seconds: number): string {
  return seconds > 0 ? '+' + time(seconds) : time(seconds);
}

/** Returns an instant with as many digits as one period needs, for example 12.345 s. */
export function instant(seconds: number): string {
  if (seconds < 60) return `${seconds.toFixed(3)}${THIN}s`;
  const minutes = Math.floor(seconds / 60);
  const rest = (seconds - 60 * minutes).toFixed(2).padStart(5, '0');
  return `${minutes}${THIN}min ${rest}${THIN}s`;
}

/** Returns a length of path in mm or m. */
export function length(mm: number): string {
  return Math.abs(mm) < 10000 ? `${significant(mm, 4)}${THIN}mm` : `${fixed(mm / 1000, 2)}${THIN}m`;
}

/** Returns a share of 1 in percent. */
export function share(part: number): string {
  const percent = 100 * part;
  if (percent > 0 && percent < 0.05) return `< 0.1${THIN}%`;
  return `${fixed(percent, Math.abs(percent) < 9.95 ? 1 : 0)}${THIN}%`;
}

/** Returns a speed in mm/s as the F word for it, in mm/min. */
export function feed(mmPerSecond: number): string {
  return `${significantWhole(60 * mmPerSecond)}${THIN}mm/min`;
}

/** Returns the number of an F word for a speed in mm/s. */
export function feedNumber(mmPerSecond: number): string {
  return significantWhole(60 * mmPerSecond);
}

function significantWhole(value: number): string {
  return Math.abs(value) >= 100 ? fixed(value, 0) : significant(value, 3);
}

export function withUnit(value: number, unit: string, digits = 3): string {
  if (unit === '%') return `${significant(value, digits)}${THIN}%`;
  return unit ? `${significant(value, digits)}${THIN}${
                    unit.replace(/^u(?=m)/, 'µ').replace(/s2$/, 's²').replace(/s3$/, 's³')}` :
                significant(value, digits);
}

export function plural(number: number, one: string, many = one + 's'): string {
  return `${count(number)} ${number === 1 ? one : many}`;
}
