#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what softcnc makes of a program: its path in the plane, coloured by the speed along it
(rapids are grey), and the speed of what it cuts over time, coloured by what limits it. The picture
of README.md is made so:

    scripts/make_picture.py build/release/apps/softcnc/softcnc programs/08_butterfly.nc docs/butterfly.svg
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

WIDTH, MARGIN, GRAPH = 880, 24, 150  # px
SHADES = 24
# Dark violet to yellow: lightness rises evenly, so that the order survives without colours.
STOPS = [(49, 18, 98), (52, 84, 160), (24, 148, 140), (110, 200, 84), (250, 224, 60)]
LIMITS = {"feed": "#2f9e44", "acceleration": "#e8590c", "jerk": "#c2255c", "chord": "#1971c2",
          "axis_velocity": "#5f3dc4", "corner": "#f08c00"}
OTHER, RAPID = "#495057", "#ced4da"


def trace_of(softcnc, part):
    """Columns of a dry run, by name."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "trace.csv"
        subprocess.run([softcnc, "run", "--dry-run", "--quiet", part, "--trace", file], check=True,
                       stdin=subprocess.DEVNULL)
        with file.open() as lines:
            rows = list(csv.DictReader(line for line in lines if line[0] != "#"))
    blocks = subprocess.run([softcnc, "blocks", "--quiet", part], check=True, stdout=subprocess.PIPE,
                            stdin=subprocess.DEVNULL)
    cuts = {block["block"] for block in map(json.loads, blocks.stdout.splitlines())
            if block["kind"] in ("feed", "arc", "nurbs")}
    trace = {name: [row[name] if name == "limit" else float(row[name]) for row in rows]
             for name in rows[0]}
    return trace | {"cuts": [int(block) in cuts for block in trace["block"]]}


def from_first_to_last_cut(trace):
    first = trace["cuts"].index(True)
    last = len(trace["cuts"]) - trace["cuts"][::-1].index(True)
    return {name: column[first:last] for name, column in trace.items()}


def shade(part):
    """Colour for 0 to 1."""
    place = min(max(part, 0), 1) * (len(STOPS) - 1)
    low = min(int(place), len(STOPS) - 2)
    mixed = (a + (b - a) * (place - low) for a, b in zip(STOPS[low], STOPS[low + 1]))
    return "#" + "".join(f"{round(value):02x}" for value in mixed)


def runs_of(keys):
    """(key, first, last) of neighbours with one key; each run begins where the last one ends."""
    first = 0
    for i in range(1, len(keys) + 1):
        if i == len(keys) or keys[i] != keys[first]:
            yield keys[first], max(first - 1, 0), i - 1
            first = i


def thinned(points, least):
    """Points at least so far apart, px, the ends among them."""
    kept = [points[0]]
    for point in points[1:-1]:
        if abs(point[0] - kept[-1][0]) + abs(point[1] - kept[-1][1]) >= least:
            kept.append(point)
    return kept + points[-1:] if len(points) > 1 else kept


def polyline(points, colour, width):
    text = " ".join(f"{x:.1f},{y:.1f}" for x, y in thinned(points, 1.6))
    return f'<polyline points="{text}" stroke="{colour}" stroke-width="{width}"/>'


def text(x, y, words, anchor="start", extra=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{words}</text>'


def path_of(trace, fastest, top, height):
    x, y = trace["x_mm"], trace["y_mm"]
    scale = min((WIDTH - 2 * MARGIN - 90) / (max(x) - min(x)), height / (max(y) - min(y)))
    left = (WIDTH - 90 - scale * (max(x) - min(x))) / 2
    points = [(left + scale * (a - min(x)), top + scale * (max(y) - b)) for a, b in zip(x, y)]
    shades = [min(int(SHADES * v / fastest), SHADES - 1) if cuts else -1
              for v, cuts in zip(trace["v_mm_s"], trace["cuts"])]
    return [polyline(points[first:last + 1], RAPID if key < 0 else shade(key / (SHADES - 1)),
                     1 if key < 0 else 2.4)
            for key, first, last in sorted(runs_of(shades), key=lambda run: run[0] >= 0)]


def scale_of(fastest, top, height):
    x, step = WIDTH - MARGIN - 62, height / SHADES
    parts = [f'<rect x="{x}" y="{top + height - (i + 1) * step:.1f}" width="16" '
             f'height="{step + 0.5:.1f}" fill="{shade(i / (SHADES - 1))}"/>' for i in range(SHADES)]
    for i in range(5):
        parts.append(text(x + 22, top + height * (1 - i / 4) + 4, f"{fastest * i / 4:.0f}"))
    return parts + [text(x + 8, top - 10, "mm/s", "middle")]


def graph_of(trace, fastest, top):
    left, width = MARGIN + 34, WIDTH - 2 * MARGIN - 34
    begin = trace["t_s"][0]
    end = trace["t_s"][-1] - begin
    points = [(left + width * (t - begin) / end, top + GRAPH * (1 - v / fastest))
              for t, v in zip(trace["t_s"], trace["v_mm_s"])]
    parts = [f'<path d="M{left} {top}V{top + GRAPH}H{left + width}" stroke="#adb5bd"/>']
    parts += [polyline(points[first:last + 1], LIMITS.get(key, OTHER), 1.6)
              for key, first, last in runs_of(trace["limit"])]
    parts += [text(left - 6, top + GRAPH * (1 - i / 2) + 4, f"{fastest * i / 2:.0f}", "end") for i in range(3)]
    parts += [text(left + width * s / end, top + GRAPH + 18, f"{s} s", "middle") for s in range(int(end) + 1)]
    held = [key for key in LIMITS if trace["limit"].count(key) > len(trace["limit"]) / 100]
    for i, key in enumerate(held):
        parts.append(text(left + 10 + 120 * i, top - 10, "— " + key, extra=f' fill="{LIMITS[key]}"'))
    return parts


def picture(trace, name):
    cut = from_first_to_last_cut(trace)
    fastest = max(v for v, cuts in zip(trace["v_mm_s"], trace["cuts"]) if cuts)
    across, up = (max(trace[c]) - min(trace[c]) for c in ("x_mm", "y_mm"))
    height = min((WIDTH - 2 * MARGIN - 90) * up / across, 460)
    top = MARGIN + 20
    total = top + height + 60 + GRAPH + MARGIN + 10
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {total:.0f}" fill="none" '
             'font-family="sans-serif" font-size="13" stroke-linejoin="round" stroke-linecap="round">',
             f"<title>Speed along the path of {name}</title>",
             f'<rect width="{WIDTH}" height="{total:.0f}" fill="#ffffff"/>', '<g fill="none">',
             *path_of(trace, fastest, top, height), "</g>", '<g fill="#343a40">',
             *scale_of(fastest, top, height), "</g>", "<g>",
             *(part if part.startswith("<poly") or part.startswith("<path")
               else part.replace("<text ", '<text fill="#343a40" ') if " fill=" not in part else part
               for part in graph_of(cut, fastest, top + height + 60)), "</g>", "</svg>"]
    return "\n".join(parts) + "\n"


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    softcnc, part, out = sys.argv[1:]
    pathlib.Path(out).write_text(picture(trace_of(softcnc, part), pathlib.Path(part).name))


if __name__ == "__main__":
    main()
