#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Polylines that take corners to the limit: a figure chopped into short chords, and a spiral of long sides; what they
may take at best, and what was measured of them, with and without rounded corners.

Every row of every trace is held against the limits of the axes and, by programmed_path.py, against the programmed
path.
"""
import math
from dataclasses import dataclass

import numpy as np

import curves
import programmed_path
import time_optimal

VELOCITY, ACCELERATION, JERK = 250.0, 1000.0, 50_000.0  # mm/s, mm/s^2, mm/s^3, of every axis
CHORD_UM = 1.0
ROUNDING = {"velocity": 1e-3, "acceleration": 1e-3, "jerk": 5e-3}
RADIUS, CHORD, CHORDS = 3.5, 0.1, 20_000                # mm, mm
SIDES = 200


class Laps:
    """Half waves y = R sin(x / R) between crest and trough, and half circles of radius R from there: a closed figure
    whose curvature has no jump, run `laps` times. By the part of a section: four sections make a lap."""

    def __init__(self, laps):
        self.breaks = np.arange(4 * laps + 1.0)

    def derivatives(self, u):
        u, r = np.asarray(u, float), RADIUS
        section = np.minimum(np.floor(u), self.breaks[-1] - 1).astype(int)
        w = math.pi * (u - section)
        c, s, one = np.cos(w), np.sin(w), np.ones_like(w)
        wave = ((w, c), (one, -s), (0 * w, -c))
        turn = ((math.pi + s, -c), (c, s), (-s, c))  # from the trough, to the left and back over the wave
        mirrored = np.where(section % 4 >= 2, -1.0, 1.0)  # the second half: x to pi - x
        result = []
        for order in range(3):
            x, y = (np.where(section % 2 == 1, b, a) for a, b in zip(wave[order], turn[order]))
            x = mirrored * x + (np.where(mirrored < 0, math.pi, 0.0) if order == 0 else 0.0)
            result.append(r * math.pi**order * np.stack([x, y, 0 * x], 1))
        return tuple(result)


def chopped(curve):
    """Points of the curve CHORD apart, but for rounding, to 1e-4 mm."""
    fine = np.linspace(0, curve.breaks[-1], 400 * (len(curve.breaks) - 1) + 1)
    s = np.concatenate([[0], np.cumsum(curves.lengths(curve, fine[:-1], fine[1:]))])
    u = np.interp(CHORD * np.arange(CHORDS + 1), s, fine)
    return np.round(curve.derivatives(u)[0][:, :2], 4)


def spiral():
    points, sides = [np.zeros(2)], [1 + 0.25 * (i // 2) for i in range(SIDES)]
    for i, side in enumerate(sides):
        points.append(points[-1] + side * np.array([(1, 0), (0, 1), (-1, 0), (0, -1)][i % 4]))
    return np.array(points), sides


def program(mode, points, feed):
    return ([f"G00 X{points[0][0]:.4f} Y{points[0][1]:.4f}", mode, f"F{feed}"]
            + [f"G01 X{x:.4f} Y{y:.4f}" for x, y in points[1:]])


def stop_to_stop(length, feed, jerk):
    """s, from rest to rest on one axis."""
    a, j = ACCELERATION, jerk or math.inf
    ramp = feed / a + a / j if feed >= a * a / j else 2 * math.sqrt(feed / j)
    if length >= feed * ramp:
        return length / feed + ramp
    if length >= 2 * a**3 / j**2:
        return 2 * (0.5 * a / j + math.sqrt((0.5 * a / j)**2 + length / a))
    return 4 * (length / (2 * j))**(1 / 3)


def smooth_bound(feed):
    """s for CHORDS * CHORD mm of the figure itself without a limit of jerk, from rest to rest: laps beyond the
    third take as long as the third."""
    limits = time_optimal.Limits(feed, (ACCELERATION,) * 3, (VELOCITY,) * 3, chord=CHORD_UM / 1e3, period=1e-3)
    two, three = (time_optimal.optimum(Laps(n), limits).time for n in (2, 3))
    lap = float(curves.lengths(Laps(1), np.arange(0.0, 4), np.arange(1.0, 5)).sum())
    return three + (CHORDS * CHORD / lap - 3) * (three - two)


@dataclass(frozen=True)
class Case:
    name: str
    mode: str
    lines: list
    feed: float        # mm/min
    jerk: float        # mm/s^3; 0: no limit
    tolerance: float   # mm
    beside: str        # what the time is held against,
    bound: float       # s,
    over: float        # and the part by which it may exceed it
    approach: float = 0.0  # s, before that


def cases():
    curve = Laps(math.ceil(CHORDS * CHORD / 48) + 1)
    points, feed = chopped(curve), 15000
    bound = smooth_bound(feed / 60)
    for mode, tolerance, jerk in (("G64 P0.005", 0.005, 0.0), ("G64 P0.005", 0.005, JERK), ("G61", 0.0, 0.0)):
        yield Case(f"{CHORDS:,} chords", mode, program(mode, points, feed), feed, jerk, tolerance, "smooth curve", bound,
                   0.02 if tolerance else math.inf, stop_to_stop(RADIUS, VELOCITY, jerk))
    corners, sides = spiral()
    for jerk in (0.0, JERK):
        stops = sum(stop_to_stop(side, 6000 / 60, jerk) for side in sides)
        for mode, tolerance in (("G61.1", 0.0), ("G64 P0.05", 0.05)):
            yield Case(f"spiral of {SIDES} sides", mode, program(mode, corners, 6000), 6000, jerk, tolerance,
                       "stop to stop", stops, -0.03 if tolerance else 0.001)


@dataclass(frozen=True)
class Measured:
    time: float        # s, without the approach
    excess: dict       # largest difference over its limit, by order
    deviation: float   # mm, rows from the program


def measured(case, report, trace, blocks):
    """Of the report of a run, its trace, and the lines that `softcnc blocks` prints."""
    padded = np.pad(trace.position, ((3, 3), (0, 0)), mode="edge")
    limits = {"velocity": VELOCITY, "acceleration": ACCELERATION} | ({"jerk": case.jerk} if case.jerk else {})
    excess = {what: float(np.abs(np.diff(padded, order, axis=0)).max()) / trace.period**order / limit
              for order, (what, limit) in enumerate(limits.items(), 1)}
    off = programmed_path.rows_off(trace.position, trace.block, programmed_path.read_blocks(blocks))
    return Measured(report["time_s"] - case.approach, excess, float(off.max()))


def broken(case, run):
    """The promises that a run does not keep."""
    if run.deviation > case.tolerance + programmed_path.ROUNDING:
        yield f"rows up to {run.deviation * 1e3:.4f} um off the program"
    for what, part_of in run.excess.items():
        if part_of > 1 + ROUNDING[what]:
            yield f"{what} {part_of:.4f} of its limit"
    if run.time > case.bound * (1 + case.over):
        yield f"{run.time:.3f} s beside {case.bound:.3f} s"
