#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How far a run lies from what is programmed, both ways, with none of softcnc's code.

    tests/oracle/programmed_path.py TRACE.csv BLOCKS.jsonl --tolerance-um P [--chord-um EPS]

BLOCKS.jsonl is what `softcnc blocks` writes of the program of the trace. Every row must lie within P of the programmed
path near its block, every programmed point within P of the polyline through the rows, but for the chord tolerance EPS.
The last row must be the end of the program. Exit 1 if not, 2 if a file cannot be read.
"""
import argparse
import json
import math
import sys

import numpy as np

import check_trace
import curves

NEAR = 100      # blocks on either side of its own in which the nearest place is looked for
SAMPLES = 96    # per smooth part of a curve
ROUNDING = 1e-9  # mm
NORMALS = {"XY": (0, 1, 2), "ZX": (2, 0, 1), "YZ": (1, 2, 0)}


class Helix:
    """An arc of the blocks, by the angle from its start; the axis across its plane moves evenly."""

    def __init__(self, block):
        self.first, self.second, self.across = NORMALS[block["plane"]]
        a, b, center = (np.array(block[key], float) for key in ("from", "to", "center"))
        x, y = a[self.first] - center[self.first], a[self.second] - center[self.second]
        begin = math.atan2(y, x)
        end = math.atan2(b[self.second] - center[self.second], b[self.first] - center[self.first])
        sweep = (end - begin) % (2 * math.pi) if block["ccw"] else -((begin - end) % (2 * math.pi))
        if abs(sweep) < 1e-9 or abs(abs(sweep) - 2 * math.pi) < 1e-9:
            sweep = math.copysign(2 * math.pi, 1 if block["ccw"] else -1)
        sweep += math.copysign(2 * math.pi * block["turns"], sweep)
        self.center, self.radius, self.begin, self.sweep = center, math.hypot(x, y), begin, sweep
        self.rise = (a[self.across], b[self.across] - a[self.across])
        # What the radius at the end differs by is rounding of the program.
        self.growth = math.hypot(b[self.first] - center[self.first], b[self.second] - center[self.second]) - self.radius
        parts = max(1, math.ceil(abs(sweep) / (math.pi / 2)))
        self.breaks = np.linspace(0, 1, parts + 1)

    def derivatives(self, u):
        u = np.asarray(u, float)
        angle, radius = self.begin + self.sweep * u, self.radius + self.growth * u
        p, p1, p2 = (np.zeros((len(u), 3)) for _ in range(3))
        c, s, w = np.cos(angle), np.sin(angle), self.sweep
        p[:, self.first] = self.center[self.first] + radius * c
        p[:, self.second] = self.center[self.second] + radius * s
        p[:, self.across] = self.rise[0] + self.rise[1] * u
        p1[:, self.first] = -w * radius * s + self.growth * c
        p1[:, self.second] = w * radius * c + self.growth * s
        p1[:, self.across] = self.rise[1]
        p2[:, self.first] = -w * w * radius * c - 2 * w * self.growth * s
        p2[:, self.second] = -w * w * radius * s + 2 * w * self.growth * c
        return p, p1, p2


def curve_of(block):
    """What a block moves along; None where it does not move."""
    if block["kind"] in ("rapid", "feed"):
        return curves.Line(block["from"], block["to"])
    if block["kind"] == "arc":
        return Helix(block)
    if block["kind"] == "nurbs":
        return curves.Nurbs(block["degree"], block["control"], block["weights"], block["knots"])
    return None


def distance_to_curve(points, curve):
    """mm, of each point from the curve."""
    if isinstance(curve, curves.Line):
        n = len(points)
        ends = (np.broadcast_to(x, (n, 3)) for x in (curve.a, curve.b))
        return check_trace.segment_distance(points[:, None, :], *ends)[:, 0]
    least = np.full(len(points), math.inf)
    for u0, u1 in zip(curve.breaks[:-1], curve.breaks[1:]):
        samples = np.linspace(u0, u1, SAMPLES + 1)
        off = np.linalg.norm(points[:, None, :] - curve.derivatives(samples)[0][None, :, :], axis=2)
        u = samples[np.argmin(off, axis=1)]
        low, high = np.maximum(u - (u1 - u0) / SAMPLES, u0), np.minimum(u + (u1 - u0) / SAMPLES, u1)
        for _ in range(60):  # halves what is left by the sign of the slope
            u = 0.5 * (low + high)
            p, p1, _ = curve.derivatives(np.clip(u, u0, u1))
            ahead = np.sum((points - p) * p1, axis=1) > 0
            low, high = np.where(ahead, u, low), np.where(ahead, high, u)
        p = curve.derivatives(np.clip(u, u0, u1))[0]
        least = np.minimum(least, np.minimum(off.min(axis=1), np.linalg.norm(points - p, axis=1)))
    return least


def read_blocks(lines):
    return [(block["block"], curve) for block in map(json.loads, lines)
            if (curve := curve_of(block)) is not None]


def rows_off(position, number, blocks):
    """mm, of each row from the programmed path near its block."""
    least = np.full(len(position), math.inf)
    for own, curve in blocks:
        near = np.searchsorted(number, [own - NEAR, own + NEAR + 1])
        rows = slice(*near)
        if near[0] < near[1]:
            least[rows] = np.minimum(least[rows], distance_to_curve(position[rows], curve))
    return least


def path_off(position, number, blocks):
    """mm, the largest distance of programmed points from the polyline through the rows near their block."""
    a, b = position[:-1], position[1:]
    largest = 0.0
    for own, curve in blocks:
        near = np.searchsorted(number, [own - NEAR, own + NEAR + 1])
        rows = slice(max(near[0] - 1, 0), min(near[1] + 1, len(a)))
        places = [np.linspace(u0, u1, 5) for u0, u1 in zip(curve.breaks[:-1], curve.breaks[1:])]
        for point in curve.derivatives(np.unique(np.concatenate(places)))[0]:
            here = np.broadcast_to(point, (rows.stop - rows.start, 1, 3))
            off = check_trace.segment_distance(here, a[rows], b[rows])
            largest = max(largest, float(off.min(initial=math.inf)))
    return largest


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trace")
    parser.add_argument("blocks")
    parser.add_argument("--tolerance-um", type=float, required=True)
    parser.add_argument("--chord-um", type=float, default=1.0)
    options = parser.parse_args(arguments)
    try:
        trace = check_trace.read_trace(options.trace)
        with open(options.blocks, encoding="utf-8") as file:
            blocks = read_blocks(file)
    except (OSError, KeyError, IndexError, ValueError) as error:
        print(f"programmed_path: {error}", file=sys.stderr)
        return 2
    allowed = options.tolerance_um / 1e3 + ROUNDING
    rows = float(rows_off(trace.position, trace.block, blocks).max())
    path = path_off(trace.position, trace.block, blocks)
    last = float(np.linalg.norm(trace.position[-1] - blocks[-1][1].derivatives(blocks[-1][1].breaks[-1:])[0][0]))
    good = True
    for what, value, most in (("rows off the programmed path", rows, allowed),
                              ("programmed path off the rows", path, allowed + options.chord_um / 1e3),
                              ("last row off the programmed end", last, ROUNDING)):
        good &= value <= most
        print(f"{'ok      ' if value <= most else 'EXCEEDED'} {what}: {value * 1e3:.6g} um, allowed {most * 1e3:.6g} um")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
