#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the table of docs/surface.md from what surface_table measures."""
import argparse
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs/surface.md"
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
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    made = table(rows(options.program))
    page = PAGE.read_text()
    head, rest = page.split(BEGIN)
    old, tail = rest.split(END)
    if options.write:
        PAGE.write_text(head + BEGIN + made + END + tail)
    elif options.check and old != made:
        sys.exit(f"{PAGE} is not what is measured; scripts/surface_table --write mends it:\n{made}")
    elif not options.check:
        print(made, end="")


main()
