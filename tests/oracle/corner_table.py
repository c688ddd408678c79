#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures what rounded corners and joined chords cost and gain, and writes it down.

    scripts/corner_table                                prints the tables as Markdown
    scripts/corner_table --write                        puts them into docs/corners.md
    tests/oracle/corner_table.py --softcnc FILE [...]   the same with this program

Every row of every trace is held against the limits of the axes and, by programmed_path.py, against the programmed
path. Exit 1 if one is broken.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass

import numpy as np

import check_trace
import curves
import programmed_path
import time_optimal

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs/corners.md"
REGION = re.compile(r"(<!-- begin table (\w+) -->\n)(.*?)(\n<!-- end table -->\n)", re.DOTALL)
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
            + [f"G01 X{x:.4f} Y{y:.4f}" for x, y in points[1:]] + ["M30"])


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
class Run:
    report: dict
    excess: dict       # largest difference over its limit, by order
    deviation: float   # mm, rows from the program


class Bench:
    def __init__(self, softcnc, folder):
        self.softcnc, self.folder = softcnc, folder
        self.broken = []

    def run(self, lines, jerk, tolerance):
        part, report, trace = (self.folder / name for name in ("part.nc", "report.json", "trace.csv"))
        part.write_text("\n".join(lines) + "\n")
        settings = {"control.chord_tolerance_um": CHORD_UM, "control.period_ms": 1.0}
        for axis in "xyz":
            settings |= {f"axis.{axis}.velocity_mm_min": VELOCITY * 60, f"axis.{axis}.jerk_mm_s3": float(jerk),
                         f"axis.{axis}.acceleration_mm_s2": ACCELERATION}
        options = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        self._softcnc("run", "--backend", "none", "--quiet", "--report", report, "--trace", trace, *options, part)
        blocks = programmed_path.read_blocks(self._softcnc("blocks", *options, part).splitlines())
        run = self._measured(json.loads(report.read_text()), check_trace.read_trace(trace), blocks, jerk, tolerance)
        if run.deviation > tolerance + programmed_path.ROUNDING:
            self.broken.append(f"{lines[1]}, J {jerk:g}: rows up to {run.deviation * 1e3:.4f} um off the program")
        for what, part_of in run.excess.items():
            if part_of > 1 + ROUNDING[what]:
                self.broken.append(f"{lines[1]}, J {jerk:g}: {what} {part_of:.4f} of its limit")
        return run

    def _softcnc(self, *words):
        done = subprocess.run([self.softcnc, *words], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{done.stderr}corner_table: softcnc {words[0]} ended with status {done.returncode}")
        return done.stdout

    @staticmethod
    def _measured(report, trace, blocks, jerk, tolerance):
        padded = np.pad(trace.position, ((3, 3), (0, 0)), mode="edge")
        limits = {"velocity": VELOCITY, "acceleration": ACCELERATION} | ({"jerk": jerk} if jerk else {})
        excess = {what: float(np.abs(np.diff(padded, order, axis=0)).max()) / trace.period**order / limit
                  for order, (what, limit) in enumerate(limits.items(), 1)}
        return Run(report, excess, float(programmed_path.rows_off(trace.position, trace.block, blocks).max()))


def row(name, mode, jerk, run, beside, bound, approach=0.0):
    report = run.report
    time = report["time_s"] - stop_to_stop(approach, VELOCITY, jerk)
    shares = " / ".join(f"{x:.3f}" for x in run.excess.values())
    us = 1e6 * report["cpu_planning_s"] / report["blocks"]
    return [name, mode, f"{jerk:g}" if jerk else "–", f"{time:.3f}", f"{beside}: {bound:.3f}",
            f"{100 * (time / bound - 1):+.1f} %", shares, f"{1e3 * run.deviation:.2f}", f"{us:.1f}"]


def measured(bench):
    rows = [["program", "mode", "J, mm/s³", "time, s", "beside, s", "over it", "velocity / acceleration / jerk over limit",
             "rows off the program, µm", "CPU planning / block, µs"]]
    curve = Laps(math.ceil(CHORDS * CHORD / 48) + 1)
    points, feed = chopped(curve), 15000
    bound = smooth_bound(feed / 60)
    for mode, tolerance in (("G64 P0.005", 0.005), ("G61", 0.0)):
        for jerk in (0, JERK) if tolerance else (0,):
            run = bench.run(program(mode, points, feed), jerk, tolerance)
            rows.append(row(f"{CHORDS:,} chords", mode, jerk, run, "smooth curve", bound, RADIUS))
    corners, sides = spiral()
    for jerk in (0, JERK):
        stops = sum(stop_to_stop(side, 6000 / 60, jerk) for side in sides)
        for mode, tolerance in (("G61.1", 0.0), ("G64 P0.05", 0.05)):
            run = bench.run(program(mode, corners, 6000), jerk, tolerance)
            rows.append(row(f"spiral of {SIDES} sides", mode, jerk, run, "stop to stop", stops))
    return rows


def markdown(rows):
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    lines.insert(1, "|---" * len(rows[0]) + "|")
    return "".join(line + "\n" for line in lines)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--softcnc", required=True, help="the program to measure")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options.softcnc, pathlib.Path(folder))
        table = markdown(measured(bench))
    for broken in bench.broken:
        print(f"BROKEN: {broken}", file=sys.stderr)
    if options.write:
        DOCS.write_text(REGION.sub(lambda region: f"{region[1]}\n{table}{region[4]}", DOCS.read_text()))
    else:
        print(table, end="")
    return 1 if bench.broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
