#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks a trace of softcnc against the exact curve, with none of its code.

    tests/oracle/check_trace.py TRACE.csv CURVE.json --chord-um EPS --acceleration MM_S2
                                [--jerk MM_S3] [--velocity MM_MIN] [--fluctuation F] [--blu-um BLU]

The program is expected to go straight from the first row to the start of the curve, and then along the curve. Exit 1
if the trace exceeds a limit, 2 if it cannot be read.
"""
import argparse
import csv
import math
import sys
from dataclasses import dataclass

import numpy as np

import curves

CHORD_SAMPLES = 65          # per period and smooth stretch of the path
SMALLEST_ADVANCE = 1e-3     # mm; the fluctuation is asked for above it
DEVIATION = 1e-6            # mm; rows lie on the path
SAME_PLACE = 1e-9           # mm: s_mm, added up otherwise
ROUNDING = 1e-3             # part of an axis limit
JERK_ROUNDING = 5e-3        # the same of a jerk


@dataclass(frozen=True)
class Trace:
    period: float         # s
    s: np.ndarray         # mm
    v: np.ndarray         # mm/s
    position: np.ndarray  # mm, a column per axis
    block: np.ndarray = None  # numbers


def read_trace(path):
    with open(path, encoding="utf-8", newline="") as file:
        lines = file.read().splitlines()
    comments = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    table = list(csv.reader(line for line in lines if not line.startswith("#")))
    header, rows = table[0], table[1:]
    columns = {name: [row[i] for row in rows] for i, name in enumerate(header)}
    numbers = lambda name: np.array(columns[name], float)
    axes = [name for name in ("x_mm", "y_mm", "z_mm") if name in columns]
    return Trace(float(comments["period_ms"]) / 1e3, numbers("s_mm"), numbers("v_mm_s"),
                 np.stack([numbers(name) for name in axes], axis=1), numbers("block"))


class Embedded:
    """A curve of fewer axes in the space of the machine; what it does not name stays 0."""

    def __init__(self, curve, axes):
        self.curve, self.axes, self.breaks = curve, axes, curve.breaks

    def derivatives(self, u):
        return tuple(np.pad(p, ((0, 0), (0, self.axes - p.shape[1]))) for p in self.curve.derivatives(u))


class Stretch:
    """A smooth part of a curve between two breaks; it begins `start` mm along the path."""

    TABLE = 400

    def __init__(self, curve, u0, u1, start):
        self.curve = curve
        self.u = np.linspace(u0, u1, self.TABLE + 1)
        self.s = start + np.concatenate([[0], np.cumsum(curves.lengths(curve, self.u[:-1], self.u[1:]))])

    def foot(self, s, points):
        """Parameters of the points of the stretch nearest to `points`, which lie near `s`: Newton's method. Where `s`
        lies outside the stretch, its end."""
        u = np.interp(s, self.s, self.u)
        inside = (s > self.s[0]) & (s < self.s[-1])
        for _ in range(30):
            p, p1, _ = self.curve.derivatives(u)
            step = np.sum((points - p) * p1, axis=1) / np.sum(p1 * p1, axis=1)
            u = np.where(inside, np.clip(u + step, self.u[0], self.u[-1]), u)
        return u

    def arc_length(self, u):
        """mm along the path."""
        i = np.clip(np.searchsorted(self.u, u, side="right") - 1, 0, self.TABLE - 1)
        return self.s[i] + curves.lengths(self.curve, self.u[i], u)


def path_to(curve, first):
    """The stretches of an approach from `first` and of the curve."""
    start = curve.derivatives(curve.breaks[:1])[0][0]
    parts = [curve] if np.array_equal(first, start) else [curves.Line(first, start), curve]
    stretches, s = [], 0.0
    for part in parts:
        for u0, u1 in zip(part.breaks[:-1], part.breaks[1:]):
            stretches.append(Stretch(part, u0, u1, s))
            s = stretches[-1].s[-1]
    return stretches


@dataclass(frozen=True)
class Measured:
    """The largest values of a whole trace."""
    chord_error: float    # mm
    deviation: float      # mm, rows from the path
    place: float          # mm, rows from where s_mm says they are, along the path
    fluctuation: float    # arc length between two rows over what s_mm grows by, minus 1
    speed_gap: float      # mm, what s_mm grows by less the integral of v_mm_s by the trapezoidal rule
    velocity: np.ndarray      # mm/s by axis
    acceleration: np.ndarray  # mm/s^2 by axis
    jerk: np.ndarray          # mm/s^3 by axis
    end: np.ndarray       # mm
    curve_end: np.ndarray


def segment_distance(points, a, b):
    """Distances of points (N, M, D) from the segments a-b (N, D)."""
    chord = (b - a)[:, None, :]
    square = np.maximum(np.sum(chord * chord, axis=2), 1e-300)
    along = np.clip(np.sum((points - a[:, None, :]) * chord, axis=2) / square, 0, 1)[:, :, None]
    return np.linalg.norm(points - a[:, None, :] - along * chord, axis=2)


class Survey:
    """What lies between the rows and around them, gathered stretch by stretch."""

    def __init__(self, trace):
        self.trace = trace
        rows = len(trace.s)
        self.chord, self.arc = np.zeros(rows - 1), np.zeros(rows - 1)
        self.deviation, self.place = np.full(rows, math.inf), np.zeros(rows)

    def add(self, stretch):
        """The rows on the stretch, and one on either side."""
        s = self.trace.s
        rows = np.arange(max(np.searchsorted(s, stretch.s[0] - SAME_PLACE) - 1, 0),
                         min(np.searchsorted(s, stretch.s[-1] + SAME_PLACE, side="right") + 1, len(s)))
        u = stretch.foot(s[rows], self.trace.position[rows])
        self._add_rows(stretch, rows, u)
        moves = u[1:] > u[:-1]
        self._add_steps(stretch, rows[:-1][moves], u[:-1][moves], u[1:][moves])

    def _add_rows(self, stretch, rows, u):
        off = np.linalg.norm(stretch.curve.derivatives(u)[0] - self.trace.position[rows], axis=1)
        nearer = off < self.deviation[rows]
        self.deviation[rows[nearer]] = off[nearer]
        self.place[rows[nearer]] = (stretch.arc_length(u) - self.trace.s[rows])[nearer]

    def _add_steps(self, stretch, steps, u0, u1):
        """Those parts of the steps from `steps` to the rows behind that lie between u0 and u1."""
        self.arc[steps] += curves.lengths(stretch.curve, u0, u1)
        between = u0[:, None] + (u1 - u0)[:, None] * np.linspace(0, 1, CHORD_SAMPLES)
        points = stretch.curve.derivatives(between.ravel())[0].reshape(*between.shape, -1)
        position = self.trace.position
        off = segment_distance(points, position[steps], position[steps + 1])
        self.chord[steps] = np.maximum(self.chord[steps], off.max(axis=1, initial=0.0))


def measure(trace, plane_curve):
    curve = Embedded(plane_curve, trace.position.shape[1])
    survey = Survey(trace)
    for stretch in path_to(curve, trace.position[0]):
        survey.add(stretch)
    advance = np.diff(trace.s)
    asked = advance > SMALLEST_ADVANCE
    padded = np.pad(trace.position, ((3, 3), (0, 0)), mode="edge")
    trapezoid = 0.5 * trace.period * (trace.v[1:] + trace.v[:-1])
    return Measured(
        chord_error=largest(survey.chord),
        deviation=largest(survey.deviation),
        place=largest(survey.place),
        fluctuation=largest(survey.arc[asked] / advance[asked] - 1),
        speed_gap=largest(advance - trapezoid),
        velocity=np.abs(np.diff(padded, axis=0)).max(axis=0) / trace.period,
        acceleration=np.abs(np.diff(padded, 2, axis=0)).max(axis=0) / trace.period**2,
        jerk=np.abs(np.diff(padded, 3, axis=0)).max(axis=0) / trace.period**3,
        end=trace.position[-1],
        curve_end=curve.derivatives(curve.breaks[-1:])[0][0])


def largest(x):
    return float(np.max(np.abs(x), initial=0.0))


def counts(position, blu):
    """Whole BLU: rounded to 1e-9 mm, then half away from zero."""
    whole = [round(x * 1e9) / round(blu * 1e9) for x in position]
    return [int(math.copysign(math.floor(abs(x) + 0.5), x)) for x in whole]


@dataclass(frozen=True)
class Verdict:
    what: str
    value: str
    allowed: str
    ok: bool


def judge(m, trace, limits):
    """One verdict per limit; `limits` are the options of the command line."""
    def at_most(what, value, allowed, unit):
        return Verdict(what, f"{value:.6g} {unit}", f"{allowed:.6g} {unit}", value <= allowed)

    verdicts = [at_most("rows off the path", m.deviation, DEVIATION, "mm"),
                at_most("chord error", m.chord_error * 1e3, limits.chord_um, "um"),
                at_most("acceleration of an axis", m.acceleration.max(), limits.acceleration * (1 + ROUNDING),
                        "mm/s^2"),
                at_most("velocity of an axis", m.velocity.max() * 60, limits.velocity * (1 + ROUNDING), "mm/min")]
    if limits.jerk:
        verdicts.append(at_most("jerk of an axis", m.jerk.max(), limits.jerk * (1 + JERK_ROUNDING), "mm/s^3"))
    if limits.fluctuation is not None:
        # Between two rows the speed can stray from a straight line by no more than full acceleration allows.
        gap = 0.25 * limits.acceleration * math.sqrt(len(m.end)) * trace.period**2
        verdicts += [at_most("s_mm from the place of the row", m.place, DEVIATION, "mm"),
                     at_most("feed fluctuation", m.fluctuation, limits.fluctuation, ""),
                     at_most("s_mm from the integral of v_mm_s in a period", m.speed_gap, gap, "mm")]
    if limits.blu_um is not None:
        end, wanted = (counts(x, limits.blu_um / 1e3) for x in (m.end, m.curve_end))
        verdicts.append(Verdict("end in counts", str(end), str(wanted), end == wanted))
    return verdicts


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trace")
    parser.add_argument("curve")
    parser.add_argument("--chord-um", type=float, required=True)
    parser.add_argument("--acceleration", type=float, required=True, help="mm/s^2, of every axis")
    parser.add_argument("--jerk", type=float, default=0.0, help="mm/s^3, of every axis; 0: no limit")
    parser.add_argument("--velocity", type=float, default=math.inf, help="mm/min, of every axis")
    parser.add_argument("--fluctuation", type=float)
    parser.add_argument("--blu-um", type=float)
    limits = parser.parse_args(arguments)
    try:
        trace, curve = read_trace(limits.trace), curves.load_nurbs(limits.curve)
    except (OSError, KeyError, IndexError, ValueError) as error:
        print(f"check_trace: {error}", file=sys.stderr)
        return 2
    verdicts = judge(measure(trace, curve), trace, limits)
    for verdict in verdicts:
        print(f"{'ok      ' if verdict.ok else 'EXCEEDED'} {verdict.what}: {verdict.value}, allowed {verdict.allowed}")
    return 0 if all(verdict.ok for verdict in verdicts) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
