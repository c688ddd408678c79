#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes programs/data/naca2412.json: points of an airfoil by its formula.

The four-digit airfoils are those of E. N. Jacobs, K. E. Ward and R. M. Pinkerton, NACA Report 460
(1933): with the camber m at the part p of the chord and the thickness t, parts of the chord,

    y_t = 5 t (0.2969 sqrt(x) - 0.1260 x - 0.3516 x^2 + 0.2843 x^3 - 0.1015 x^4)
    y_c = m / p^2 (2 p x - x^2)                      up to p
    y_c = m / (1 - p)^2 (1 - 2 p + 2 p x - x^2)      beyond it

and y_t is laid off square to the line of y_c. The points go from the trailing edge along the upper
side to the leading edge and back along the lower one, at even steps of b with x = (1 - cos b) / 2, in
which the curve is smooth at the leading edge. The trailing edge is open, as in the report.

    scripts/generate airfoil            writes the file; scripts/generate programs then writes the program
    scripts/generate airfoil --check    changes nothing; exit 1 if the file is not up to date
"""
import json
import math
import pathlib
import sys

FILE = pathlib.Path(__file__).resolve().parents[3] / "programs/data/naca2412.json"
CODE, CHORD, STEPS, DIGITS = "2412", 100.0, 60, 5  # mm; steps for each side; after the point


def thickness(t, x):
    return 5 * t * (0.2969 * math.sqrt(x) + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1015 * x))))


def camber(m, p, x):
    """The height of the mean line, and its slope."""
    if m == 0:
        return 0.0, 0.0
    k, constant = (m / p ** 2, 0.0) if x < p else (m / (1 - p) ** 2, 1 - 2 * p)
    return k * (constant + 2 * p * x - x * x), k * 2 * (p - x)


def point(code, x, side):
    """A point of the upper (1) or lower (-1) side over the part x of the chord, in chords."""
    m, p, t = int(code[0]) / 100, int(code[1]) / 10, int(code[2:]) / 100
    height, slope = camber(m, p, x)
    angle, half = math.atan(slope), thickness(t, x)
    return x - side * half * math.sin(angle), height + side * half * math.cos(angle)


def points(code, chord, steps):
    """mm, from the trailing edge over the upper side and the leading edge to the trailing edge."""
    for i in range(-steps, steps + 1):
        x = (1 - math.cos(math.pi * abs(i) / steps)) / 2
        across, up = point(code, x, 1 if i < 0 else -1)
        yield [round(chord * across, DIGITS) + 0.0, round(chord * up, DIGITS) + 0.0]


def text():
    rows = ",\n".join(f"    {json.dumps(place)}" for place in points(CODE, CHORD, STEPS))
    return (f'{{\n  "title": "NACA {CODE}",\n'
            f'  "source": "Jacobs, Ward and Pinkerton, NACA Report 460 (1933): the formula, at {2 * STEPS + 1} points; '
            f'scripts/generate airfoil",\n'
            f'  "through": true,\n  "columns": ["X", "Y"],\n  "points": [\n{rows}\n  ]\n}}\n')


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    if not arguments:
        FILE.write_text(text())
    elif FILE.read_text() != text():
        sys.exit(f"{FILE.name} is not what scripts/generate airfoil makes")


if __name__ == "__main__":
    main(sys.argv[1:])
