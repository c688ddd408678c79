#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""What the papers state, against docs/figures/data: the files from which their figures are drawn.

    tests/oracle/papers_test.py
"""
import pathlib
import sys
import xml.etree.ElementTree

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts/papers"))
from runs import read  # noqa: E402

FIGURES = ROOT / "docs/figures"
DATA = FIGURES / "data"
LARGEST_PICTURE = 300_000  # bytes
TABLE_3 = {"sam": (8001, 0.392587, 0.999875), "m-sam": (5658, 0.302568, 0.999500),
           "dda": (6284, 0.306079, 0.999500), "dsm": (5658, 0.225151, 0.496906),
           "m-dsm": (5658, 0.225151, 0.496906)}

wrong = []


def check(name, value, expected, margin):
    holds = abs(value - expected) <= margin
    print(f"{'' if holds else 'WRONG '}{name}: {value:.6g}, {expected:g} within {margin:g}")
    if not holds:
        wrong.append(name)


def check_range(name, value, least, most):
    check(name, value, (least + most) / 2, (most - least) / 2)


def of(columns, column, **wanted):
    rows = [i for i in range(len(columns[column]))
            if all(columns[name][i] == value for name, value in wanted.items())]
    return numpy.array([columns[column][i] for i in rows])


def paper_000():
    run = {name: read(DATA / f"000_{name}.csv") for name in
           ("plan_005", "plan_2", "scheme_005", "scheme_2", "fixed")}
    most = {name: columns["chord_error_um"].max() for name, columns in run.items()}
    for name, allowed in (("plan_005", 0.05), ("plan_2", 2.0)):
        check_range(f"000 {name}: the limit is kept, and used", most[name], 0.99 * allowed, allowed)
    check("000 figure 6: the scheme exceeds its bound, times", most["scheme_005"] / 0.05, 8.3, 0.05)
    check("000 figure 9: the scheme exceeds its bound, times", most["scheme_2"] / 2, 3.3, 0.1)
    starts = read(DATA / "000_starts.csv")
    worst = dict(zip(starts["run"], starts["worst_um"]))
    median = dict(zip(starts["run"], starts["median_um"]))
    for name, allowed in (("000_plan_005", 0.05), ("000_plan_2", 2.0)):
        check_range(f"{name}: the limit is kept from every start", worst[name], 0.99 * allowed, allowed)
    # Another program's walks along the curve, from 16 (scheme) and 64 starts (chords).
    check("000 figure 9: from the worst start, um", worst["000_scheme_2"], 6.682, 0.1)
    check("000 figure 9: median over the starts, um", median["000_scheme_2"], 6.285, 0.1)
    check("000 figure 10: from the worst start, um", worst["000_fixed"], 263.2, 3)
    check("000 figure 10: median over the starts, um", median["000_fixed"], 161.75, 0.5)
    check_range("000 figure 6: the scheme exceeds its bound from the worst start, times",
                worst["000_scheme_005"] / 0.05, 9.3, 10.5)
    # At a fixed feed the chord of one period on a circle: r - sqrt(r^2 - (F T / 2)^2).
    curve = read(DATA / "000_curve.csv")
    step = 2000 / 60 * 0.008
    gentle = run["fixed"]["chord_error_um"]
    radius = 1 / numpy.interp(step * numpy.arange(len(gentle)), curve["s_mm"], curve["curvature_1_mm"])
    even = (radius > 5) & (radius < 50)
    closed = 1000 * (radius - numpy.sqrt(numpy.maximum(radius ** 2 - step ** 2 / 4, 0)))
    check("000 figure 10: median ratio to the closed form where it is gentle",
          numpy.median(gentle[even] / closed[even]), 1, 0.03)
    feed = run["plan_005"]["feed_mm_min"]
    check_range("000 figure 8: no feed above F2000", feed.max(), 1900, 2000.1)


def paper_003():
    table = read(DATA / "003_table3.csv")
    for i, method in enumerate(table["method"]):
        places, mean, most = TABLE_3[method]
        check(f"003 table 3, {method}: places", table["places"][i], places, 0)
        check(f"003 table 3, {method}: mean error", table["mean_error_blu"][i], mean, 0)
        check(f"003 table 3, {method}: largest error", table["largest_error_blu"][i], most, 0)
    feeds = read(DATA / "003_4.csv")
    for method in ("m-sam", "dsm", "m-dsm"):
        for constant, degrees, ratio in ((1, 45, 1.0607), (0, 45, 1.4142)):
            value = of(feeds, "ratio", path="line", method=method, constant_feed=constant, degrees=degrees)[0]
            check(f"003 figure 4, {method}, {degrees} degrees, compensated {constant}", value, ratio, 1e-4)
        least = of(feeds, "ratio", path="line", method=method, constant_feed=1).min()
        check(f"003 figure 4, {method}, lowest compensated", least, 0.9487, 1e-4)
    sam = of(feeds, "ratio", path="line", method="sam", constant_feed=0, degrees=45)[0]
    check("003 figure 4, sam, 45 degrees, not compensated", sam, 0.7071, 1e-4)
    arcs = numpy.concatenate([of(feeds, "ratio", path="arc", method=method, constant_feed=1)
                              for method in ("sam", "m-sam", "dsm", "m-dsm")])
    check("003 figure 4, arc, lowest compensated", arcs.min(), 0.973, 0.0015)
    check("003 figure 4, arc, highest compensated", arcs.max(), 1.066, 0.0015)
    runs_of_003()
    ramp = read(DATA / "003_5.csv")
    rising = ramp["t_s"] < 0.045
    # At a constant acceleration the rate grows evenly from rest: 1000 mm/s2 of 2.5 um.
    slope = numpy.polyfit(ramp["t_s"][rising], ramp["frequency_hz"][rising], 1)[0]
    check("003 figure 5: growth of the rate, 1/s2", slope, 1000 / 0.0025, 0.02 * 1000 / 0.0025)
    stairs = read(DATA / "003_3.csv")
    for method in TABLE_3:
        steps = numpy.abs(numpy.diff(numpy.column_stack([of(stairs, axis, method=method)
                                                         for axis in ("x_mm", "y_mm")]), axis=0))
        check(f"003 figure 3, {method}: longest move along an axis, mm", steps.max(), 2, 0)


def runs_of_003():
    """Runs agree with the closed forms over the slope m, by either clock."""
    ran = read(DATA / "003_4_runs.csv")
    worst = {}
    for path, clock, constant, method, degrees, ratio in zip(*ran.values()):
        if path != "line":
            continue
        m = numpy.tan(numpy.radians(degrees))
        length = numpy.sqrt(1 + m * m)
        if method == "dda" or (clock == "profile" and constant == "on"):
            expected = 1.0
        elif constant == "on":
            expected = length / (1 + m / 3)
        else:
            expected = length / (1 + m) if method == "sam" else length
        key = clock, constant
        worst[key] = max(worst.get(key, 0), abs(ratio - expected))
    for (clock, constant), error in worst.items():
        check(f"003 figure 4, runs by the clock {clock}, constant feed {constant}", error, 0, 5e-4)


def paper_004():
    planes = read(DATA / "004_4_5.csv")
    rmax = dict(zip(planes["figure"], planes["rmax_um"]))
    check("004 figure 5, 0 degrees, um", rmax[5], 24.9, 0.05 * 24.9)
    check("004 figure 4, 10 degrees, um", rmax[4], 10.7, 0.05 * 10.7)
    check("004 figure 14, 0.33 mm, um", rmax[14], 10.2, 0.07 * 10.2)
    fine, coarse = (read(DATA / f"004_map{name}.csv") for name in ("", "_20"))
    at = of(fine, "zmap_um", inclination_deg=0, feed_mm=0.5)[0]
    check("004 figure 3: map and machined plane, um", at, rmax[5], 0.2)
    for name, table in (("2.5 um", fine), ("20 um", coarse)):  # the paper: 1.8 um
        largest = numpy.abs(table["paper_um"] - table["zmap_um"]).max()
        check_range(f"004 figure 6, grid of {name}: largest error, um", largest, 1.8, 2.5)
    margin = (fine["guaranteed_um"] / fine["zmap_um"] - 1).min()
    check_range("004: least margin of the guaranteed model over the Z-map", margin, -0.006, 0.02)
    critical = read(DATA / "004_critical.csv")
    check("004 figure 7: critical inclination at one pick-feed", critical["critical_deg"][-1], 4.344, 5e-4)
    begins = critical["feed_per_pick"][critical["critical_deg"] > 0].min()
    check("004 figure 7: feed at which it begins, pick-feeds", begins, 0.534, 0.01)
    hill = read(DATA / "004_12.csv")
    middle = numpy.abs(hill["part_of_length"] - 0.5) < 0.25
    check("004 figure 12: lowest feed, part of F6000", hill["feed_mm_min"][middle].min() / 6000, 0.653, 0.005)
    fixed = read(DATA / "004_8_fixed_rmax.csv")
    beside = numpy.abs(fixed["inclination_deg"]) > 8
    twice = fixed["rmax_um"].max() / numpy.median(fixed["rmax_um"][beside])
    check_range("004 figure 8: the top at a fixed feed, times the rest", twice, 1.9, 2.4)
    variable = read(DATA / "004_8_variable_rmax.csv")
    check_range("004 figure 8: largest Rmax at the variable feed, um", variable["rmax_um"].max(), 10.67, 13)
    table = read(DATA / "004_table1.csv")
    check("004 table 1: ratio of times", table["time_s"][1] / table["time_s"][0], 1.021, 0.003)


def pictures():
    files = sorted(FIGURES.glob("*.svg"))
    check_range("pictures", len(files), 20, 40)
    for file in files:
        check_range(f"{file.name}: bytes", file.stat().st_size, 1000, LARGEST_PICTURE)
        root = xml.etree.ElementTree.parse(file).getroot()
        if "date" in file.read_text().split("<defs>")[0] or not root.tag.endswith("svg"):
            wrong.append(f"{file.name} has a date, or is no picture")


def main():
    for part in (paper_000, paper_003, paper_004, pictures):
        part()
    print(*wrong, sep="\n")
    return len(wrong)


if __name__ == "__main__":
    sys.exit(main())
