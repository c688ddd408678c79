// SPDX-License-Identifier: MIT
// The part programs of the tests: some of the repository, some written here.

/** Returns a program of about `count` chords along a wave around a circle. */
export function chords(count) {
  const lines = ['(a wave around a circle, by chords)', 'G21 G90 G17 G94 G64 P0.005', 'G00 Z5',
    'G00 X40 Y0', 'G01 Z0 F600', 'F6000'];
  for (let k = 1; k <= count; k++) {
    const a = 2 * Math.PI * 25 * k / count;
    const r = 40 + 12 * Math.sin(a / 25) + 2 * Math.sin(7.2 * a);
    lines.push(`X${(r * Math.cos(a)).toFixed(3)} Y${(r * Math.sin(a)).toFixed(3)}`);
  }
  return [...lines, 'G00 Z5', 'M30', ''].join('\n');
}

/** Returns to-and-fro passes over a wavy surface: `raster` of the project's oracle programs. */
export function raster(passes = 1500, points = 334) {
  const lines = ['G21 G90 G17 G94 G64 P0.01', 'G0 X0 Y0 Z20', 'G1 Z10 F500', 'F4000'];
  for (let pass = 0; pass < passes; pass++) {
    const y = pass * 0.2;
    for (let k = 0; k < points; k++) {
      const x = 0.3 * (pass % 2 === 0 ? k : points - 1 - k);
      const z = 5 + 3 * Math.sin(x / 9) * Math.cos(y / 11) + 0.5 * Math.sin((x + y) / 3);
      lines.push(`X${x.toFixed(3)} Y${y.toFixed(3)} Z${z.toFixed(3)}`);
    }
  }
  return [...lines, 'G0 Z20', 'M30', ''].join('\n');
}

/** A program with two errors and a warning, whose lines the tests know. */
export const kErrors = {
  text: ['(a program with errors)', 'G21 G90 G17 G94', 'G00 X0 Y0 Z5', 'G01 Z0 F300',
    'G02 X20 Y0 I9 J0', 'G01 X30 Y10 F900000', 'X40 Y10 Q', 'M30', ''].join('\n'),
  errorLines: [5, 7],
};

/** Each has a `file` of the repository or a `text`, and `options` of `softcnc report`. */
export const kPrograms = {
  butterfly: { file: 'programs/curves/butterfly.nc', options: ['--what-if'] },
  chords: { text: () => chords(100000) },
  comparison: {
    file: 'programs/curves/butterfly.nc',
    options: ['--compare', 'programs/machines/bench_mill.toml'],
  },
  passes: { text: () => raster(300, 200) },
  errors: { text: () => kErrors.text, fails: true },
  loops: { file: 'programs/14_loops_and_subprograms.nc' },
  surface: {
    file: 'programs/21_paper004_surface.nc',
    options: ['--machine', 'programs/21_paper004_surface.toml'],
  },
};
