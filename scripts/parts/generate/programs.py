#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the curves of programs/data into the part programs that show them.

In a program, what stands between the comments

    (begin curve NAME FNNN)
    (end curve)

is made from programs/data/NAME.json: one block of G06.2 per control point and one per closing
knot, at the feed FNNN; if the curve is one "through" its points, a rapid to the first one and one
block of G06.1 for each of the others. Everything else in a program is written by hand.

    scripts/generate programs            writes the programs
    scripts/generate programs --check    changes nothing; exit 1 if a program is not up to date
"""
import json
import pathlib
import re
import sys

PROGRAMS = pathlib.Path(__file__).resolve().parents[3] / "programs"
REGION = re.compile(r"^(\(begin curve (\w+) (F\d+)\)\n).*?^(\(end curve\)\n)", re.M | re.S)


def number(value):
    """The shortest decimal text that reads back as this value; G-code knows no exponents."""
    text = repr(float(value)).removesuffix(".0")
    assert "e" not in text, f"{value} needs an exponent"
    return text


def words(columns, point):
    """The words of a control point; a weight of 1 is left out."""
    letters = ["R" if column == "weight" else column for column in columns]
    return " ".join(letter + number(value) for letter, value in zip(letters, point)
                    if (letter, value) != ("R", 1))


def nurbs(curve, feed):
    """The lines of a curve in the form of FANUC's G06.2."""
    points, knots, order = curve["points"], curve["knots"], curve["degree"] + 1
    assert len(knots) == len(points) + order, "knots are control points plus order"
    lines = [f"K{number(knot)} {words(curve['columns'], point)}"
             for knot, point in zip(knots, points)]
    lines[0] = f"G06.2 P{order} {lines[0]} {feed}"
    return lines + [f"K{number(knot)}" for knot in knots[len(points):]]


def spline(curve, feed):
    """The lines of a spline through points: G06.1, from the first of them on."""
    first, *others = (words(curve["columns"], point) for point in curve["points"])
    return [f"G00 {first}", f"G06.1 {others[0]} {feed}", *others[1:]]


def up_to_date(text):
    def fill(match):
        begin, name, feed, end = match.groups()
        curve = json.loads((PROGRAMS / "data" / f"{name}.json").read_text())
        lines = spline(curve, feed) if curve.get("through") else nurbs(curve, feed)
        return begin + "".join(line + "\n" for line in lines) + end
    return REGION.sub(fill, text)


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    stale = False
    for program in sorted(PROGRAMS.rglob("*.nc")):
        text = program.read_text()
        made = up_to_date(text)
        if made == text:
            continue
        if arguments:
            print(f"{program.name} is not what scripts/generate programs makes of its data")
            stale = True
        else:
            program.write_text(made)
            print(f"wrote {program.name}")
    sys.exit(1 if stale else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
