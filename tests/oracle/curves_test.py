#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The programs of programs/curves against what is known of their curves without this code.

    tests/oracle/curves_test.py SOFTCNC
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts/parts/generate"))
import airfoil as naca  # noqa: E402


def trace_of(softcnc, name):
    """Columns of the rows with a feed, and of the one at which they end."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "trace.npz"
        subprocess.run([softcnc, "run", "--quiet", "--progress", "none", "--backend", "none",
                        ROOT / f"programs/curves/{name}.nc", "--trace", file], check=True, stdin=subprocess.DEVNULL)
        with numpy.load(file) as arrays:
            trace = {column: arrays[column] for column in ("s_mm", "x_mm", "y_mm", "feed_mm_s")}
    rows = numpy.flatnonzero(trace["feed_mm_s"] > 0)
    return {column: values[rows[0]:rows[-1] + 2] for column, values in trace.items()}


def off_polyline(trace, line):
    """The largest distance, mm, of the rows from a polyline of many points."""
    places, most = numpy.column_stack([trace["x_mm"], trace["y_mm"]]), 0.0
    for place in places[::5]:
        near = numpy.argmin(numpy.hypot(*(line - place).T))
        ends = line[max(near - 1, 0):near + 2]
        along = numpy.diff(ends, axis=0)
        part = numpy.clip(((place - ends[:-1]) * along).sum(1) / (along ** 2).sum(1), 0, 1)
        most = max(most, numpy.hypot(*(ends[:-1] + part[:, None] * along - place).T).min())
    return most


def airfoil(softcnc):
    """The spline through 121 points is within 1 um of the formula."""
    x = (1 - numpy.cos(numpy.linspace(0, numpy.pi, 40001))) / 2
    upper, lower = ([naca.point("2412", part, side) for part in x] for side in (1, -1))
    line = naca.CHORD * numpy.array(upper[::-1] + lower[1:])
    return off_polyline(trace_of(softcnc, "naca2412"), line)


def airfoil_table():
    """NACA 0012 has its published thickness: 6.002 % half at 30 % of the chord, 0.126 % at its end."""
    at = naca.point("0012", 0.3, 1)[1], naca.point("0012", 1.0, 1)[1]
    return max(abs(at[0] - 0.06002), abs(at[1] - 0.00126))


def circle(softcnc):
    """Every row lies on the circle of 10 mm."""
    trace = trace_of(softcnc, "circle")
    return numpy.abs(numpy.hypot(trace["x_mm"], trace["y_mm"]) - 10).max()


def length(softcnc, name, known):
    """Published lengths, mm, to the digits that are published."""
    return abs(numpy.ptp(trace_of(softcnc, name)["s_mm"]) - known)


def closed(softcnc, name):
    """The distance, mm, from the begin of a curve to its end; the published butterfly leaves 1 um."""
    trace = trace_of(softcnc, name)
    return numpy.hypot(*(trace[axis][-1] - trace[axis][0] for axis in ("x_mm", "y_mm")))


def main():
    softcnc = sys.argv[1]
    figures = [("airfoil, distance from its formula, mm", airfoil(softcnc), 1e-3),
               ("airfoil, published ordinates, chords", airfoil_table(), 5e-6),
               ("circle, distance from its radius, mm", circle(softcnc), 1e-9),
               ("circle, length, mm", length(softcnc, "circle", 20 * numpy.pi), 1e-3),
               ("butterfly, length, mm", length(softcnc, "butterfly", 382.86), 6e-3),
               ("butterfly, gap, mm", closed(softcnc, "butterfly"), 1.1e-3),
               ("figure eight, gap, mm", closed(softcnc, "infinity"), 1e-6)]
    wrong = [name for name, value, most in figures if not value <= most]
    print(*(f"{value:.3g} of {most:g}: {name}" for name, value, most in figures), sep="\n")
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main())
