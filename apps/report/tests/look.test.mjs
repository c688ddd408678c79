// SPDX-License-Identifier: MIT
import assert from 'node:assert/strict';
import test from 'node:test';

import {load} from './load.mjs';

const numbers = await load('ui/common/numbers.ts');
const {dimmed, neutral, rgbOf, salience} = await load('ui/common/palette.ts');
const {limitColour} = await load('ui/common/limits.ts');

const spaced = (text) => text.replace(/\u202f/g, ' ').replace(/\u2212/g, '-');

test('times read as people say them', () => {
  const cases = [
    [0, '0 s'], [0.0123, '0.012 s'], [0.9996, '1.00 s'], [5.495, '5.50 s'], [12.34, '12.3 s'],
    [59.94, '59.9 s'], [59.96, '1 min 00.0 s'], [83.44, '1 min 23.4 s'], [3599.4, '59 min 59.4 s'],
    [3600, '1 h 00 min'], [7384, '2 h 03 min'], [-83.4, '-1 min 23.4 s']
  ];
  for (const [seconds, text] of cases) assert.equal(spaced(numbers.time(seconds)), text);
  assert.equal(spaced(numbers.timeChange(0.5)), '+0.500 s');
  assert.equal(spaced(numbers.lineTime(0.0048)), '4.8 ms');
  assert.equal(spaced(numbers.instant(75.5)), '1 min 15.50 s');
});

test('numbers have as many digits as they mean', () => {
  assert.equal(numbers.fixed(1234567.8, 1), '1,234,567.8');
  assert.equal(spaced(numbers.fixed(-0.04, 1)), '0.0');
  assert.equal(spaced(numbers.fixed(-12, 0)), '-12');
  assert.equal(numbers.significant(0.0123456), '0.0123');
  assert.equal(numbers.significant(603.42, 4), '603.4');
  assert.equal(numbers.plain(1.0), '1');
  assert.equal(numbers.plain(2.4), '2.4');
  assert.equal(numbers.plain(1500), '1500');
  assert.equal(spaced(numbers.share(0.0004)), '< 0.1 %');
  assert.equal(spaced(numbers.share(0.584)), '58 %');
  assert.equal(spaced(numbers.feed(100)), '6000 mm/min');
  assert.equal(spaced(numbers.length(458.278)), '458.3 mm');
  assert.equal(spaced(numbers.length(153180)), '153.18 m');
  assert.equal(spaced(numbers.withUnit(12.345, 'um')), '12.3 µm');
});

/** Relative luminance of WCAG 2. */
function luminance(rgb) {
  const [r, g, b] = rgb.map(
      (value) => (value <= 10 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

const contrast = (a, b) => {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
};

for (const [name, dark, paper] of [['light', false, [255, 255, 255]], ['dark', true, [21, 24, 29]]])
  test(
      `the ${name} scale leaves the background step by step, so that it reads without colour`,
      () => {
        const steps = Array.from({length: 51}, (_, i) => contrast(salience(i / 50, dark), paper));
        for (let i = 1; i < steps.length; ++i) assert.ok(steps[i] > steps[i - 1], `step ${i}`);
        assert.ok(steps[50] > 8 && steps[50] / steps[0] > 4);
        assert.ok(contrast(dimmed(dark), paper) < contrast(neutral(dark), paper));
      });

test('limits have colours of their own', () => {
  const limits = [
    'feed', 'rapid', 'chord', 'corner', 'roughness', 'axis_velocity', 'acceleration', 'jerk',
    'pulse_rate', 'tangential', 'normal', 'custom', 'override', 'hold', 'stop'
  ];
  const colours = limits.map((limit) => rgbOf(limitColour(limit)));
  assert.equal(new Set(colours.map(String)).size, limits.length);
});
