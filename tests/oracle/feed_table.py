#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures how fast and how exactly softcnc plans and runs curves, mixed paths and polylines, and writes it down.

    scripts/generate feed                        prints the tables as Markdown
    scripts/generate feed --write                puts them into docs/feed.md
    scripts/generate feed --check                compares with docs/feed.md, except CPU times
    tests/oracle/feed_table.py --softcnc FILE --plan-program FILE [...]    the same with these programs

Every trace is checked by check_trace.py, every time is held against time_optimal.py. Exit 1 if a promise is broken or
the tables are not those of docs/feed.md.
"""
import argparse
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
from dataclasses import dataclass, replace
from itertools import zip_longest

import check_trace
import curves
import mixed_paths
import polylines
import time_optimal

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts/parts/generate"))
import programs  # noqa: E402

DATA = ROOT / "tests/data"
DOCS = ROOT / "docs/feed.md"
JERK_REFERENCES = pathlib.Path(__file__).with_name("jerk_references.json")
CURVES = ("circle_deg2", "infinity8", "butterfly")
METHODS = ("arc-length", "taylor1", "taylor2", "curvature3p", "rk4", "yeh-hsu-1999", "yeh-hsu-2002",
           "chords")
ACCELERATION = 1000.0  # mm/s^2, of every axis
UNLIMITED = 1e7        # mm/s^2, the largest a machine file may name
BLU_UM = 2.5
FLUCTUATION = 1e-6
MACHINE = {"velocity_mm_min": 15000.0, "min_mm": -1000.0, "max_mm": 1000.0, "blu_um": BLU_UM}


@dataclass(frozen=True)
class Setting:
    feed: float       # mm/min
    period_ms: float
    chord_um: float
    over: float       # part by which the time may exceed the optimum
    method: str = "arc-length"
    acceleration: float = ACCELERATION
    jerk: float = 0.0  # mm/s^3; 0: no limit

    def words(self):
        return f"F{self.feed:.0f}, {self.period_ms:g} ms, {self.chord_um:g} µm"

    def options(self):
        values = {"control.period_ms": self.period_ms, "control.servo_period_ms": self.period_ms,
                  "control.chord_tolerance_um": self.chord_um,
                  "control.interpolation": self.method}
        for axis in "xyz":
            values[f"axis.{axis}.acceleration_mm_s2"] = self.acceleration
            values[f"axis.{axis}.jerk_mm_s3"] = self.jerk
            values |= {f"axis.{axis}.{key}": value for key, value in MACHINE.items()}
        return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


FEED_BINDS = Setting(6000, 1, 1, 0.01)
COARSE, FINE = Setting(2000, 8, 2, 0.05), Setting(2000, 8, 0.05, 0.05)  # those of paper 000
# Each twice, at a feed that binds almost everywhere and at one that binds almost nowhere.
JERK_SETTINGS = tuple(Setting(feed, 1, 1, 0.02, acceleration=acceleration, jerk=jerk)
                      for acceleration, jerk in ((1000.0, 5e4), (3000.0, 6e4), (5000.0, 5e5))
                      for feed in (3000, 15000))
SETTINGS = (FEED_BINDS, Setting(6000, 4, 1, 0.05), COARSE, FINE)
FREE_SETTINGS = tuple(Setting(feed, 1, 1, 0.005, acceleration=acceleration) for acceleration in (1000.0, 3000.0, 5000.0)
                      for feed in (3000, 15000))
OVER_WHOLE = 0.01
SECONDS = 0.3  # of planning, for each of its times


@dataclass(frozen=True)
class Run:
    """The report of a run, its trace as measured from outside, and the time of the curve alone."""
    report: dict
    measured: check_trace.Measured
    verdicts: list
    time: float


@dataclass(frozen=True)
class Optimum:
    time: float         # s
    chord_error: float  # mm, of a machine that is sent its points once per period


def optimum(name, setting):
    curve = shape(name, setting.feed).curve
    limits = time_optimal.Limits(setting.feed / 60, (setting.acceleration,) * 3,
                                 chord=setting.chord_um / 1e3, period=setting.period_ms / 1e3)
    profile = time_optimal.optimum(curve, limits)
    s, v, parameter = profile.sampled(limits.period)
    rows = check_trace.Trace(limits.period, s, v, curve.derivatives(parameter)[0])
    return Optimum(profile.time, check_trace.measure(rows, curve).chord_error)


class Bench:
    """Runs softcnc, each case once, in a folder of its own."""

    def __init__(self, softcnc, plan_program, folder, seconds):
        self.softcnc, self.plan_program, self.folder, self.seconds = softcnc, plan_program, folder, seconds
        self.runs = {}
        self.broken = []  # promises

    def run(self, name, setting):
        if (name, setting) not in self.runs:
            self.runs[name, setting] = self._run(name, setting)
        return self.runs[name, setting]

    def promise(self, held, what):
        if not held:
            self.broken.append(what)

    def _run(self, name, setting):
        drawn = shape(name, setting.feed)
        before = self._report(drawn.approach, setting)["time_s"] if drawn.approach else 0.0
        report = self._report(drawn.approach + drawn.lines, setting)
        trace = check_trace.read_trace(self.folder / "trace.csv")
        measured = check_trace.measure(trace, drawn.curve)
        limits = argparse.Namespace(chord_um=setting.chord_um, acceleration=setting.acceleration, velocity=15000.0,
                                    jerk=setting.jerk, fluctuation=FLUCTUATION, blu_um=BLU_UM)
        return Run(report, measured, check_trace.judge(measured, trace, limits),
                   report["time_s"] - waited(report) - before)

    def run_polyline(self, case, setting):
        report = self._report(case.lines, setting)
        blocks = self._ask(self.softcnc, "blocks", *setting.options(), self._program(case.lines)).splitlines()
        return polylines.measured(case, report, check_trace.read_trace(self.folder / "trace.csv"), blocks)

    def plan(self, lines, setting):
        """What planning alone takes, streamed and with the whole program in one plan."""
        values = setting.options()[1::2]
        return json.loads(self._ask(self.plan_program, str(self.seconds), self._program(lines), *values))

    def _report(self, lines, setting):
        report = self.folder / "report.json"
        self._ask(self.softcnc, "run", "--backend", "none", "--quiet", "--report", report, "--trace",
                  self.folder / "trace.csv", *setting.options(), self._program(lines))
        return json.loads(report.read_text())

    def _program(self, lines):
        program = self.folder / "program.nc"
        program.write_text("\n".join([*lines, "M30"]) + "\n")
        return program

    @staticmethod
    def _ask(*words):
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{done.stderr}feed_table: {words[0]} {words[1]} ended with status {done.returncode}")
        return done.stdout


@dataclass(frozen=True)
class Shape:
    """A path, and the lines of a program that runs it."""
    curve: object
    approach: list
    lines: list


def shape(name, feed):
    if name in mixed_paths.PATHS:
        pen = mixed_paths.draw(name)
        return Shape(mixed_paths.Joined(pen.curves), [], ["G61", f"F{feed:.0f}", *pen.code])
    data = json.loads((DATA / f"{name}.json").read_text())
    return Shape(curves.load_nurbs(DATA / f"{name}.json"), approach_to(data["control_points"][0]), nurbs_lines(data, feed))


def approach_to(point):
    """A straight line from the origin, where programs begin; none where the curve begins there too."""
    words = " ".join(letter + programs.number(x) for letter, x in zip("XY", point))
    return [f"G00 {words}"] if any(point) else []


def nurbs_lines(data, feed):
    points = [point + [weight] for point, weight in zip(data["control_points"], data["weights"])]
    curve = {"points": points, "columns": ["X", "Y", "weight"], "knots": data["knots"], "degree": data["degree"]}
    return programs.nurbs(curve, f"F{feed:.0f}")


def waited(report):
    """Where approach and curve meet the machine may wait for the next setpoint, s; that belongs to neither."""
    return report["time_by_limit_s"].get("stop", 0.0)


def seconds(time):
    return f"{time:.{3 if time > 1 else 4}f}"


def percent(part):
    """Two figures, and as many digits as they need."""
    digits = max(0, 1 - math.floor(math.log10(100 * part))) if part > 0 else 0
    return f"{100 * part:.{digits}f} %"


def fluctuation(part):
    return "< 1e-9" if part < 1e-9 else percent(part)


def times_table(bench):
    rows = [("curve", "setting", "time, s", "optimum, s", "over it", "chord error / tolerance",
             "the optimum's", "acceleration / limit", "end, counts")]
    for name in CURVES:
        for setting in SETTINGS:
            run, best = bench.run(name, setting), optimum(name, setting)
            over = round(run.time / best.time - 1, 4) + 0.0
            hold_promises(bench, run, over, setting, f"{name}, {setting.words()}")
            x, y, _ = counted(run.measured.end)
            rows.append((name, setting.words(), seconds(run.time), seconds(best.time), f"{100 * over:.2f} %",
                         f"{run.measured.chord_error * 1e3 / setting.chord_um:.3f}",
                         f"{best.chord_error * 1e3 / setting.chord_um:.3f}",
                         f"{run.measured.acceleration.max() / setting.acceleration:.4f}", f"x {x}, y {y}"))
    return rows


def hold_promises(bench, run, over, setting, case):
    """What is promised for interpolation by arc length, and that the report tells what was measured from outside."""
    for verdict in run.verdicts:
        bench.promise(verdict.ok, f"{case}: {verdict.what} is {verdict.value}, allowed {verdict.allowed}")
    bench.promise(0 <= over <= setting.over, f"{case}: {100 * over:.2f} % over the optimum")
    report, measured = run.report, run.measured
    bench.promise(list(report["counts"].values()) == counted(measured.curve_end),
                  f"{case}: the counts of the report are not those of the end")
    bench.promise(math.isclose(report["chord_error_um_max"], measured.chord_error * 1e3, rel_tol=0.01),
                  f"{case}: the report's chord error is not what was measured")
    bench.promise(math.isclose(max(report["acceleration_max"].values()), measured.acceleration.max(), rel_tol=1e-6),
                  f"{case}: the report's acceleration is not what was measured")


def counted(position):
    return check_trace.counts(position, BLU_UM / 1e3)


PLANNED = ("path", "mode", "A, mm/s²", "J, mm/s³", "F", "time, s", "beside", "s", "over it",
           "velocity / acceleration / jerk over limit", "off the program, µm", "over one plan of all", "nodes",
           "iterations", "fall-backs", "CPU motion / planning", "CPU / block, µs", "CPU / node, ns")


def planned_table(bench):
    references = json.loads(JERK_REFERENCES.read_text())["times"]
    rows = [PLANNED]
    for name in (*CURVES, *mixed_paths.PATHS):
        for setting in FREE_SETTINGS + JERK_SETTINGS:
            run, what = bench.run(name, setting), f"{setting.acceleration:.0f}, {setting.jerk:.0f}"
            best = references[name][f"{what}, F{setting.feed:.0f}"] if setting.jerk else optimum(name, setting).time
            over, case = run.time / best - 1, f"{name}, {what}, {setting.words()}"
            for verdict in run.verdicts:
                bench.promise(verdict.ok, f"{case}: {verdict.what} is {verdict.value}, allowed {verdict.allowed}")
            bench.promise(over <= setting.over, f"{case}: {percent(over)} over the reference")
            drawn, limits = shape(name, setting.feed), (250, setting.acceleration, setting.jerk)
            shares = [difference.max() / limit for difference, limit in
                      zip((run.measured.velocity, run.measured.acceleration, run.measured.jerk), limits) if limit]
            plan = bench.plan(drawn.approach + drawn.lines, setting)
            rows.append((name, "G61", *limit_cells(setting), seconds(run.time), "reference" if setting.jerk else "optimum",
                         seconds(best), f"{round(100 * over, 2) + 0.0:.2f} %", parts(shares), "–", *plan_cells(bench, case, plan)))
    for case in polylines.cases():
        setting = Setting(case.feed, 1, polylines.CHORD_UM, case.over, acceleration=polylines.ACCELERATION, jerk=case.jerk)
        run, what = bench.run_polyline(case, setting), f"{case.name}, {case.mode}, J {case.jerk:g}"
        for broken in polylines.broken(case, run):
            bench.promise(False, f"{what}: {broken}")
        plan = bench.plan(case.lines, setting)
        rows.append((case.name, case.mode, *limit_cells(setting), seconds(run.time), case.beside, seconds(case.bound),
                     f"{100 * (run.time / case.bound - 1):.2f} %", parts(run.excess.values()), f"{1e3 * run.deviation:.2f}",
                     *plan_cells(bench, what, plan)))
    return rows


def limit_cells(setting):
    return f"{setting.acceleration:.0f}", f"{setting.jerk:.0f}" if setting.jerk else "–", f"{setting.feed:.0f}"


def parts(shares):
    return " / ".join(f"{share:.3f}" for share in shares)


def plan_cells(bench, case, plan):
    """Without limits of jerk the nodes are those of the grid, and nothing is iterated."""
    over = plan["motion_s"] / plan["whole_motion_s"] - 1
    bench.promise(over <= OVER_WHOLE, f"{case}: streamed, {percent(over)} over one plan of the whole program")
    nodes, planning = plan["plan_nodes"] or plan["nodes"], plan["planning_s"]
    return (f"{round(100 * over, 2) + 0.0:.2f} %" if plan["whole_fallbacks"] == 0 else "–", nodes, plan["iterations"] or "–",
            plan["fallbacks"], f"{plan['motion_s'] / planning:.0f}", f"{1e6 * planning / plan['blocks']:.2f}",
            f"{1e9 * planning / nodes:.0f}")


def methods_table(bench):
    rows = [("setting", "method", "time, s", "feed fluctuation", "chord error / tolerance", "acceleration / limit")]
    cases = [replace(setting, method=method) for setting in (FEED_BINDS, COARSE, FINE) for method in METHODS]
    cases += [replace(setting, method="curvature3p", acceleration=UNLIMITED) for setting in (COARSE, FINE)]
    for setting in cases:
        run = bench.run("butterfly", setting)
        limited = setting.acceleration < UNLIMITED
        rows.append((setting.words() + ("" if limited else ", any acceleration"), setting.method, seconds(run.time),
                     fluctuation(run.report["feed_fluctuation_max"]),
                     f"{run.measured.chord_error * 1e3 / setting.chord_um:.2f}",
                     f"{run.measured.acceleration.max() / setting.acceleration:.2f}" if limited else "–"))
    return rows


def costs_table(bench):
    rows = [("curve", "setting", "nodes", "passes", "setpoints", "CPU planning, ms", "CPU planning / setpoint, µs",
             "CPU interpolation / setpoint, µs")]
    for name in CURVES:
        for setting in SETTINGS:
            report = bench.run(name, setting).report
            per_setpoint = 1e6 / report["setpoints"]
            rows.append((name, setting.words(), report["planner_nodes"], report["planner_passes"], report["setpoints"],
                         f"{1e3 * report['cpu_planning_s']:.1f}", f"{per_setpoint * report['cpu_planning_s']:.2f}",
                         f"{per_setpoint * report['cpu_interpolation_s']:.2f}"))
    return rows


TABLES = {"planned": planned_table, "times": times_table, "methods": methods_table, "costs": costs_table}
REGION = re.compile(r"(<!-- begin table (\w+) -->\n)(.*?)(\n<!-- end table -->\n)", re.DOTALL)


def markdown(rows):
    lines = ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    lines.insert(1, "|---" * len(rows[0]) + "|")
    return "".join(line + "\n" for line in lines)


def without_cpu(table):
    """The cells of a Markdown table but for the columns of CPU times."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.strip().splitlines()]
    if not rows:
        return []
    kept = [i for i, head in enumerate(rows[0]) if not head.startswith("CPU")]
    return [[row[i] for i in kept] for row in rows]


def same_cell(a, b):
    """Equal, or numbers that differ by no more than one in the last digit."""
    if a == b:
        return True
    try:
        x, y = (float(cell.removesuffix(" %")) for cell in (a, b))
    except (AttributeError, ValueError):
        return False
    digits = len(a.removesuffix(" %").partition(".")[2])
    return abs(x - y) < 1.5 * 10.0**-digits


def same_row(a, b):
    return a is not None and b is not None and len(a) == len(b) and all(map(same_cell, a, b))


def check(tables):
    """True if docs/feed.md has these tables; names the rows that differ."""
    written = {name: table for _, name, table, _ in REGION.findall(DOCS.read_text())}
    same = True
    for name, table in tables.items():
        for measured, found in zip_longest(without_cpu(table), without_cpu(written.get(name, ""))):
            if not same_row(measured, found):
                same = False
                print(f"table {name}: measured {measured}, docs/feed.md says {found}", file=sys.stderr)
    return same


def write(tables):
    DOCS.write_text(REGION.sub(lambda region: f"{region[1]}\n{tables[region[2]]}{region[4]}", DOCS.read_text()))


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--softcnc", required=True, help="the program to measure")
    parser.add_argument("--plan-program", required=True, help="the one that plans without reading")
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true")
    action.add_argument("--write", action="store_true")
    options = parser.parse_args(arguments)
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options.softcnc, options.plan_program, pathlib.Path(folder), 0 if options.check else SECONDS)
        tables = {name: markdown(table(bench)) for name, table in TABLES.items()}
    for broken in bench.broken:
        print(f"BROKEN: {broken}", file=sys.stderr)
    same = True
    if options.write:
        write(tables)
    elif options.check:
        same = check(tables)
    else:
        print("\n".join(tables.values()), end="")
    return 0 if same and not bench.broken else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
