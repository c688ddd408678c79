#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the table of docs/surface.md: Rmax by the Z-map and by the model of paper 004, as in its
figure 6, with the Z-map as it is. Without an option the table is printed as Markdown.
"""
import argparse
import pathlib
import subprocess
import sys

from built import built

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs/surface.md"
BEGIN, END = "<!-- surface_table -->\n", "<!-- end -->\n"


def rows(program):
    text = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    return [tuple(float(cell) for cell in line.split("\t")) for line in text.splitlines()]


def table(figures):
    """Markdown: a row for each inclination, "Z-map / model" for each feed per tooth."""
    feeds = sorted({feed for _, feed, _, _ in figures if feed != 0.33})
    of = {(incline, feed): (cut, model) for incline, feed, cut, model in figures}
    lines = ["| inclination | " + " | ".join(f"{feed:.2f} mm" for feed in feeds) + " |",
             "|---" * (len(feeds) + 1) + "|"]
    for incline in sorted({row[0] for row in figures}):
        cells = [f"{of[incline, feed][0]:.1f} / {of[incline, feed][1]:.1f}" for feed in feeds]
        lines.append(f"| {incline:g}° | " + " | ".join(cells) + " |")
    worst = max(figures, key=lambda row: abs(row[2] - row[3]))
    tip = of[0.0, 0.33]
    return "\n".join(lines) + (
        f"\n\nThe largest error is {worst[3] - worst[2]:+.1f} µm, at {worst[0]:g}° and {worst[1]:.2f} mm. "
        f"At 0° and 0.33 mm, the feed of the paper's figure 14, the Z-map says {tip[0]:.1f} µm.\n")


def main():
    parser = argparse.ArgumentParser(prog="scripts/generate surface", description=__doc__)
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true",
                        help="compares with docs/surface.md; exit 1 on a difference")
    action.add_argument("--write", action="store_true", help="puts the table there")
    parser.add_argument("program", nargs="?", metavar="SURFACE_TABLE",
                        help="the program that measures; built if it is not named")
    options = parser.parse_args()
    made = table(rows(options.program or built("surface_table")))
    page = PAGE.read_text()
    head, rest = page.split(BEGIN)
    old, tail = rest.split(END)
    if options.write:
        PAGE.write_text(head + BEGIN + made + END + tail)
    elif options.check and old != made:
        sys.exit(f"{PAGE} is not what is measured; scripts/generate surface --write mends it:\n{made}")
    elif not options.check:
        print(made, end="")


main()
