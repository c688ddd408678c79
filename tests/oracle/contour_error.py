#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The contour error of a trace of the simulated mill, worked out from the exact curve with none of softcnc's code.

    tests/oracle/contour_error.py TRACE.csv CURVE.json

The program is expected to go straight from the first row to the start of the curve, and then along the curve. Each
row's actual position is held against the path between the last nearest point and 1 mm beyond the commanded point;
where it has swung back from the last nearest point by less than 5 um, against the tangent there.
Shows, in um: the largest error on the curve and its time, the rms there, the same on the approach, and by how much
the column contour_um differs from this at most.
"""
import csv
import sys
from dataclasses import dataclass

import numpy as np

import curves

AHEAD = 1.0         # mm of path beyond the commanded point
SPACING = 2e-3      # mm of path from sample to sample, in the mean
LEAST = 400         # samples between two breaks
SWING = 5e-3        # mm


@dataclass(frozen=True)
class Rows:
    t: np.ndarray         # s
    s: np.ndarray         # mm
    command: np.ndarray   # mm, a column per axis
    actual: np.ndarray    # mm, likewise
    contour: np.ndarray   # um


def read_rows(path):
    with open(path, encoding="utf-8", newline="") as file:
        table = list(csv.reader(line for line in file if not line.startswith("#")))
    columns = {name: [row[i] for row in table[1:]] for i, name in enumerate(table[0])}
    numbers = lambda name: np.array(columns[name], float)
    axes = [axis for axis in "xyz" if f"{axis}_mm" in columns]
    return Rows(numbers("t_s"), numbers("s_mm"), np.stack([numbers(f"{axis}_mm") for axis in axes], axis=1),
                np.stack([numbers(f"{axis}_act_mm") for axis in axes], axis=1), numbers("contour_um"))


def sampled(curve, axes):
    """Points of the curve and the arc length of each, which begins at 0."""
    u = [curve.breaks[:1]]
    for u0, u1 in zip(curve.breaks[:-1], curve.breaks[1:]):
        grid = np.linspace(u0, u1, 101)
        length = curves.lengths(curve, grid[:-1], grid[1:]).sum()
        u.append(np.linspace(u0, u1, max(LEAST, int(length / SPACING)) + 1)[1:])
    u = np.concatenate(u)
    s = np.concatenate([[0], np.cumsum(curves.lengths(curve, u[:-1], u[1:]))])
    points = curve.derivatives(u)[0]
    return np.pad(points, ((0, 0), (0, axes - points.shape[1]))), s


def sampled_path(rows, curve):
    """Points of an approach and of the curve, their arc lengths, and where the approach ends."""
    points, s = sampled(curve, rows.command.shape[1])
    start = rows.command[0]
    approach = np.linalg.norm(points[0] - start)
    if approach == 0:
        return points, s, 0.0
    part = np.linspace(0, 1, max(2, int(approach / SPACING)))[:-1, None]
    return (np.concatenate([start + part * (points[0] - start), points]),
            np.concatenate([part[:, 0] * approach, approach + s]), approach)


def to_segments(point, points, s, first, window):
    """Distances of the point from the segments that begin at these indices, as far as they lie in the window of arc
    lengths, and the arc length of each at which it is nearest."""
    a, way = points[first], points[first + 1] - points[first]
    length = s[first + 1] - s[first]
    part = np.sum((point - a) * way, axis=1) / np.sum(way * way, axis=1)
    at = np.clip(s[first] + np.clip(part, 0, 1) * length, *window)
    return np.linalg.norm(point - a - ((at - s[first]) / length)[:, None] * way, axis=1), at


def beside(point, foot, points, s):
    """The distance of a point from the path at a foot that it may have swung back from."""
    i = min(np.searchsorted(s, foot, side="right") - 1, len(s) - 2)
    way = points[i + 1] - points[i]
    off = points[i] + (foot - s[i]) / (s[i + 1] - s[i]) * way - point
    ahead = off @ way / np.linalg.norm(way)
    distance = np.linalg.norm(off)
    return np.sqrt(max(distance**2 - ahead**2, 0)) if 0 < ahead < SWING else distance


def contour_errors(rows, points, s):
    """mm of each row, and the arc length of its nearest point."""
    error, foot = np.zeros(len(rows.s)), np.zeros(len(rows.s))
    last = 0.0
    for i, actual in enumerate(rows.actual):
        window = last, rows.s[i] + AHEAD
        low = max(np.searchsorted(s, last, side="right") - 1, 0)
        high = min(np.searchsorted(s, window[1]) + 1, len(s))
        near = low + int(np.argmin(np.sum((points[low:high] - actual) ** 2, axis=1)))
        first = np.arange(max(near - 2, low), min(near + 2, high - 1))
        if len(first) == 0:
            first = np.array([len(s) - 2])
        off, at = to_segments(actual, points, s, first, window)
        stays = at[off.argmin()] == last
        error[i], last = off.min(), at[off.argmin()]
        if stays:
            error[i] = beside(actual, last, points, s)
        foot[i] = last
    return error, foot


def figures(rows, curve):
    """A dictionary of what is shown."""
    points, s, approach = sampled_path(rows, curve)
    error, foot = contour_errors(rows, points, s)
    on_curve = foot >= approach
    result = {}
    for name, chosen in (("curve", on_curve), ("approach", ~on_curve)):
        part = error[chosen] * 1e3
        result[name] = (part.max(initial=0), rows.t[chosen][part.argmax()] if len(part) else 0,
                        np.sqrt(np.mean(part**2)) if len(part) else 0)
    result["column"] = np.abs(error * 1e3 - rows.contour).max()
    return result


def main(arguments):
    trace, curve = arguments
    found = figures(read_rows(trace), curves.load_nurbs(curve))
    for name in ("curve", "approach"):
        largest, at, rms = found[name]
        print(f"{name}: {largest:.4f} um at most, at {at:.5f} s, rms {rms:.4f} um")
    print(f"contour_um differs by {found['column']:.6f} um at most")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
