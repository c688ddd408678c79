#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes Table 3 of paper 003, the other tables of docs/pulses.md, and its figure, with the
interpolators as they are. Without an option the tables are printed as Markdown.
"""
import argparse
import pathlib
import subprocess
import sys

from built import built

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs/pulses.md"
FIGURE = ROOT / "docs/pulses.svg"
NAMES = {"sam": "SAM", "m-sam": "M_SAM", "dda": "DDA", "dsm": "DSM", "m-dsm": "M_DSM"}
COLOURS = {"sam": "#b5651d", "m-sam": "#1f77b4", "dda": "#7f7f7f", "dsm": "#2ca02c", "m-dsm": "#d62728"}


def rows(program, what):
    text = subprocess.run([program, what], check=True, capture_output=True, text=True).stdout
    return [line.split("\t") for line in text.splitlines()]


def table(head, lines):
    """Markdown."""
    return "\n".join(f"| {' | '.join(cells)} |" for cells in [head, ["---"] * len(head), *lines]) + "\n"


def table_3(paper):
    of = {method: figures for _, method, *figures in paper}
    return table(["method", "places", "mean error", "largest error"],
                 [[NAMES[m], of[m][0], of[m][2], of[m][3]] for m in NAMES])


def spread(least, most):
    return least if least == most else f"{least} … {most}"


def table_of_circles(circles):
    lines = [[radius, NAMES[method], *(spread(*figures[i:i + 2]) for i in range(0, 10, 2)),
              "exact" if figures[10] == "0" else f"{figures[10]} BLU off"]
             for radius, method, *figures in circles]
    return table(["R, BLU", "method", "pulses of a quadrant", "mean error", "largest error",
                  "mean error across", "largest error across", "ends"], lines)


def curves(feeds, path):
    """{(method, compensated): [(degrees, ratio), ...]}"""
    of = {}
    for kind, method, compensated, degrees, ratio in feeds:
        if kind == path:
            of.setdefault((method, compensated == "1"), []).append((float(degrees), float(ratio)))
    return of


def panel(left, title, most_degrees, of):
    """One diagram, 380 wide: ratio over degrees; compensated lines are whole, others dashed."""
    x = lambda degrees: left + 50 + 300 * degrees / most_degrees
    y = lambda ratio: 330 - 280 * (ratio - 0.6) / 0.9
    parts = [f'<text x="{left + 200}" y="30" text-anchor="middle">{title}</text>',
             f'<rect x="{x(0):.1f}" y="{y(1.5):.1f}" width="300" height="280" fill="none" stroke="#888"/>']
    for tenths in range(6, 16):
        ratio = tenths / 10
        parts.append(f'<line x1="{x(0):.1f}" y1="{y(ratio):.1f}" x2="{x(most_degrees):.1f}" y2="{y(ratio):.1f}" stroke="#ddd"/>')
        parts.append(f'<text x="{x(0) - 6:.1f}" y="{y(ratio) + 4:.1f}" text-anchor="end">{ratio}</text>')
    for degrees in range(0, most_degrees + 1, 15):
        parts.append(f'<text x="{x(degrees):.1f}" y="348" text-anchor="middle">{degrees}°</text>')
    for (method, compensated), points in of.items():
        path = " ".join(f"{x(degrees):.1f},{y(ratio):.1f}" for degrees, ratio in points)
        dash = "" if compensated else ' stroke-dasharray="5 4"'
        parts.append(f'<polyline points="{path}" fill="none" stroke="{COLOURS[method]}" stroke-width="1.6"{dash}/>')
    return parts


def figure(feeds):
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 780 410" font-family="sans-serif" font-size="12">',
             '<rect width="780" height="410" fill="white"/>']
    parts += panel(0, "line: feed over its slope", 45, curves(feeds, "line"))
    parts += panel(390, "arc: feed over its angle", 90, curves(feeds, "arc"))
    for i, (method, shown) in enumerate(NAMES.items()):
        parts.append(f'<line x1="{60 + 90 * i}" y1="380" x2="{85 + 90 * i}" y2="380" stroke="{COLOURS[method]}" stroke-width="2"/>')
        parts.append(f'<text x="{90 + 90 * i}" y="384">{shown}</text>')
    parts.append('<text x="520" y="384">whole: compensated, dashed: not</text>')
    return "\n".join([*parts, "</svg>"]) + "\n"


def table_of_feeds(feeds):
    lines = []
    for method, shown in NAMES.items():
        cells = [shown]
        for path in ("line", "arc"):
            for compensated in (False, True):
                ratios = [ratio for _, ratio in curves(feeds, path)[method, compensated]]
                cells.append(f"{min(ratios):.3f} … {max(ratios):.3f}")
        lines.append(cells)
    return table(["method", "line", "compensated", "arc", "compensated"], lines)


def with_table(page, name, text):
    begin, end = f"<!-- begin table {name} -->\n", "<!-- end table -->"
    before, rest = page.split(begin)
    return before + begin + text + rest[rest.index(end):]


def main(arguments):
    parser = argparse.ArgumentParser(prog="scripts/generate pulses", description=__doc__)
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true",
                        help="compares with docs/pulses.md and docs/pulses.svg; exit 1 on a difference")
    action.add_argument("--write", action="store_true", help="puts the tables and the figure there")
    parser.add_argument("program", nargs="?", metavar="PULSE_TABLE",
                        help="the program that measures; built if it is not named")
    options = parser.parse_args(arguments)
    program = options.program or built("pulse_table")
    paper, circles, feeds = (rows(program, what) for what in ("paper", "circles", "feeds"))
    tables = {"paper": table_3(paper), "circles": table_of_circles(circles), "feeds": table_of_feeds(feeds)}
    if not (options.check or options.write):
        print("\n".join(tables.values()), end="")
        return 0
    page = PAGE.read_text(encoding="utf-8")
    for name, text in tables.items():
        page = with_table(page, name, text)
    if options.write:
        PAGE.write_text(page, encoding="utf-8")
        FIGURE.write_text(figure(feeds), encoding="utf-8")
        return 0
    same = page == PAGE.read_text(encoding="utf-8") and figure(feeds) == FIGURE.read_text(encoding="utf-8")
    if not same:
        print("docs/pulses.md or docs/pulses.svg differ: scripts/generate pulses --write", file=sys.stderr)
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
