#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The independent checks, checked: against closed forms, against a linear program, and by traces that are wrong.

    tests/oracle/oracle_test.py SOFTCNC
"""
import contextlib
import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import lil_matrix

import check_trace
import contour_error
import curves
import time_optimal

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "tests/data"
BUTTERFLY = DATA / "butterfly.json"
BLU = 0.0025  # mm


def limits(feed, acceleration, **more):
    return time_optimal.Limits(feed, (acceleration,) * 3, **more)


class Curves(unittest.TestCase):
    def test_nine_points_make_a_circle(self):
        circle = curves.load_nurbs(DATA / "circle_deg2.json")
        u = np.linspace(0, 1, 1001)[:-1]
        tangent, bend = curves.unit_speed(circle, u)
        points = circle.derivatives(u)[0]
        np.testing.assert_allclose(np.linalg.norm(points, axis=1), 10, rtol=1e-14)
        np.testing.assert_allclose(bend, -points / 100, atol=1e-13)
        np.testing.assert_allclose(np.sum(tangent * points, axis=1), 0, atol=1e-12)
        u = circle.breaks
        self.assertAlmostEqual(curves.lengths(circle, u[:-1], u[1:]).sum(), 20 * math.pi, places=11)

    def test_derivatives_are_those_of_the_position(self):
        butterfly = curves.load_nurbs(BUTTERFLY)
        u, h = np.linspace(0.05, 0.95, 500), 1e-6
        u = u[np.min(np.abs(u[:, None] - butterfly.breaks), axis=1) > 2 * h]
        before, at, after = (butterfly.derivatives(x) for x in (u - h, u, u + h))
        for order in (0, 1):
            slope = (after[order] - before[order]) / (2 * h)
            scale = np.abs(at[order + 1]).max()
            self.assertLess(np.abs(slope - at[order + 1]).max() / scale, 1e-6)


class TimeOptimal(unittest.TestCase):
    def test_a_line_takes_as_long_as_its_trapezoid(self):
        line = curves.Line((0, 0, 0), (30, 40, 0))  # the y axis limits: 800 of 1000 mm/s^2
        time = time_optimal.optimum(line, limits(100, 800)).time
        self.assertAlmostEqual(time, 50 / 100 + 100 / 1000, delta=1e-4 * time)

    def test_a_short_line_takes_as_long_as_its_triangle(self):
        time = time_optimal.optimum(curves.Line((0, 0), (2, 0)), limits(100, 500)).time
        self.assertAlmostEqual(time, 2 * math.sqrt(2 / 500), delta=1e-4 * time)

    def test_a_circle_runs_at_its_chord_cap(self):
        eps, period = 1e-4, 8e-3
        speed = 2 * math.sqrt(2 * 10 * eps - eps**2) / period
        arc = curves.Arc((0, 0), 10, 0, 2 * math.pi)
        profile = time_optimal.optimum(arc, limits(1000, 1000, chord=eps, period=period))
        self.assertAlmostEqual(math.sqrt(profile.q.max()), speed, delta=1e-9 * speed)
        self.assertAlmostEqual(profile.time, 20 * math.pi / speed, delta=2 * speed / 1000)

    def test_axis_velocity_holds_on_each_axis(self):
        line = curves.Line((0, 0), (30, 40))
        profile = time_optimal.optimum(line, limits(100, 1e6, velocity=(60, 8, 60)))
        self.assertAlmostEqual(math.sqrt(profile.q.max()), 10, places=9)

    def test_no_axis_exceeds_its_limit_and_one_is_nearly_always_at_it(self):
        feed, acceleration = 100, 1000
        butterfly = curves.load_nurbs(BUTTERFLY)
        profile = time_optimal.optimum(butterfly, limits(feed, acceleration))
        used = np.abs(profile.axis_acceleration()).max(axis=1)
        self.assertLess(used.max(), acceleration * (1 + 1e-9))
        at_feed = np.minimum(profile.q[1:], profile.q[:-1]) > feed**2 * (1 - 1e-9)
        idle = (used < 0.999 * acceleration) & ~at_feed
        dt = np.diff(profile.instants)
        self.assertLess(dt[idle].sum(), 5e-3 * profile.time)

    def test_two_passes_find_what_a_linear_program_finds(self):
        """On the same grid, with the largest sum of q instead of two passes."""
        butterfly = curves.load_nurbs(BUTTERFLY)
        asked = limits(100, 1000)
        ours = time_optimal.fastest(butterfly, time_optimal.Spacing(butterfly), 4000, asked)
        h, n = np.diff(ours.s), len(ours.s)
        matrix = lil_matrix((4 * (n - 1), n))
        row = 0
        for i in range(n - 1):
            for turn, bend in zip(ours.middle_tangent[i], ours.middle_bend[i]):
                for sign in (1, -1):
                    matrix[row, i] = sign * (bend / 2 - turn / (2 * h[i]))
                    matrix[row, i + 1] = sign * (bend / 2 + turn / (2 * h[i]))
                    row += 1
        bounds = [(0, 0)] + [(0, asked.feed**2)] * (n - 2) + [(0, 0)]
        found = linprog(-np.ones(n), matrix.tocsr(), np.full(row, 1000.0), bounds=bounds, method="highs")
        v = np.sqrt(found.x)
        time = np.sum(2 * h / (v[1:] + v[:-1]))
        self.assertAlmostEqual(ours.time, time, delta=1e-4 * time)


class CheckTrace(unittest.TestCase):
    """A trace of the butterfly as softcnc makes it, and the same with one thing wrong."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.trace = pathlib.Path(folder.name) / "trace.csv"
        subprocess.run([SOFTCNC, "run", "--backend", "none", "--quiet", "--trace", self.trace,
                        ROOT / "programs/08_butterfly.nc"], check=True, capture_output=True)
        self.lines = self.trace.read_text().splitlines()
        self.first = next(i for i, line in enumerate(self.lines) if line[0].isdigit())
        self.rows = list(csv.DictReader([self.lines[0], *self.lines[self.first:]]))

    def verdict(self, *options):
        """The exit status, and what was exceeded."""
        self.trace.write_text("\n".join(self.lines) + "\n")
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            status = check_trace.main([str(self.trace), str(BUTTERFLY), "--chord-um", "1", "--acceleration", "1000",
                                       "--velocity", "15000", "--fluctuation", "1e-6", "--blu-um", "2.5", *options])
        return status, [line.split(":")[0][9:] for line in said.getvalue().splitlines() if line.startswith("EXC")]

    def edit(self, row, column, change):
        """Changes a number of a row."""
        values = dict(self.rows[row])
        values[column] = repr(float(values[column]) + change)
        self.lines[self.first + row % len(self.rows)] = ",".join(values.values())

    def test_the_trace_holds_every_limit(self):
        self.assertEqual(self.verdict(), (0, []))

    def test_any_row_moved_by_one_blu_is_found(self):
        for row in np.linspace(1, len(self.rows) - 2, 4).astype(int):
            for column in ("x_mm", "y_mm"):
                with self.subTest(row=row, column=column):
                    kept = self.lines[self.first + row]
                    self.edit(row, column, BLU)
                    status, exceeded = self.verdict()
                    self.assertEqual(status, 1)
                    self.assertIn("acceleration of an axis", exceeded)
                    self.lines[self.first + row] = kept

    def test_another_end_is_found(self):
        self.edit(-1, "x_mm", BLU)
        self.assertIn("end in counts", self.verdict()[1])

    def test_a_wrong_place_is_found(self):
        self.edit(2000, "s_mm", 1e-5)
        status, exceeded = self.verdict()
        self.assertEqual(status, 1)
        self.assertIn("s_mm from the place of the row", exceeded)
        self.assertIn("feed fluctuation", exceeded)

    def test_a_missing_row_is_found(self):
        del self.lines[self.first + 3000]
        status, exceeded = self.verdict()
        self.assertEqual(status, 1)
        self.assertIn("s_mm from the integral of v_mm_s in a period", exceeded)

    def test_tighter_limits_are_exceeded(self):
        self.assertEqual(self.verdict("--chord-um", "0.15"), (1, ["chord error"]))
        self.assertEqual(self.verdict("--acceleration", "990"), (1, ["acceleration of an axis"]))
        self.assertEqual(self.verdict("--velocity", "5900"), (1, ["velocity of an axis"]))

    def test_a_trace_that_is_none_is_refused(self):
        self.lines = self.lines[:2]
        with contextlib.redirect_stderr(io.StringIO()):
            self.assertEqual(self.verdict()[0], 2)


class ContourError(unittest.TestCase):
    """What the simulated mill reports of the butterfly, at every instant of its loop, against the exact curve."""

    def check(self, *options):
        with tempfile.TemporaryDirectory() as folder:
            trace, report = pathlib.Path(folder) / "t.csv", pathlib.Path(folder) / "r.json"
            subprocess.run([SOFTCNC, "run", "--quiet", "--progress", "none", "--trace", trace, "--report", report,
                            "--set", "control.period_ms=0.25", "--set", "control.servo_period_ms=0.25", *options,
                            ROOT / "programs/08_butterfly.nc"], check=True, capture_output=True)
            found = contour_error.figures(contour_error.read_rows(trace), curves.load_nurbs(BUTTERFLY))
            told = json.loads(report.read_text())
        largest, at, rms = found["curve"]
        self.assertAlmostEqual(told["contour_error_um_max"], largest, delta=0.01)
        self.assertAlmostEqual(told["contour_error_um_rms"], rms, delta=0.01)
        self.assertAlmostEqual(told["contour_error_at"]["t_s"], at, places=9)
        self.assertAlmostEqual(told["contour_error_rapid_um_max"], found["approach"][0], delta=0.01)
        self.assertLess(found["column"], 0.02)

    def test_the_reported_contour_error_is_that_of_the_curve(self):
        self.check()

    def test_it_is_with_the_stiffest_loop(self):
        self.check("--set", "axis.x.drive.kv_1_s=1000", "--set", "axis.y.drive.kv_1_s=1000")


if __name__ == "__main__":
    SOFTCNC = sys.argv.pop(1)
    unittest.main()
