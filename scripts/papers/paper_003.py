# SPDX-License-Identifier: MIT
"""Paper 003: interpolators by reference pulses (figures 3, 4, 5, 7, Tables 3 and 6)."""
import math

import numpy

from drawing import COLOURS, figure, grid, legend_below, save
from runs import PROGRAMS, cuts, read, write

NAMES = {"sam": "SAM", "m-sam": "M_SAM", "dda": "DDA", "dsm": "DSM", "m-dsm": "M_DSM"}
OF = dict(zip(NAMES, COLOURS))
# Lines that lie on each other stay visible.
WIDTHS = {"sam": 1.2, "m-sam": 4.0, "dda": 1.2, "dsm": 2.4, "m-dsm": 1.0}
INPUT = "16_paper003_input.nc"
SPLINE = "f 600\ns 5   10 16   20 -40   15 35\n      15 -15  -10 -10\n"
COARSE = ["axis.x.blu_um=2000", "axis.y.blu_um=2000", "axis.z.blu_um=2000", "control.backend=none"]
# Ramps of 5 % of the line.
RAMP_PART, RAMP_BLU = "f 3000\nl 20 0\n", 0.0025
EVERY = 20  # of the pulses of a ramp, what is kept
# No ramps: the feed is the same from the first clock on.
AT_ONCE = ["axis.x.acceleration_mm_s2=1e6", "axis.y.acceleration_mm_s2=1e6", "control.backend=none"]
FEED, WAY, RADIUS = 1500.0, 60.0, 10.0  # mm/min, mm; 10 mm are the 4000 BLU of Table 3
SLOPES = range(0, 46, 5)


def settings(method, clock, constant):
    return [f"control.interpolation={method}", f"control.pulse_clock={clock}",
            f"control.constant_feed={constant}"]


def measure_table(tools, data):
    rows = {method: figures for _, method, *figures in tools.rows_of("pulse_table", "paper")}
    columns = {"method": list(NAMES)}
    for i, name in enumerate(("places", "moves", "mean_error_blu", "largest_error_blu")):
        columns[name] = [rows[method][i] for method in NAMES]
    write(data / "003_table3.csv", columns, {})


def measure_feeds(tools, data):
    kinds, methods, constant, degrees, ratios = zip(*tools.rows_of("pulse_table", "feeds"))
    write(data / "003_4.csv", {"path": kinds, "method": methods, "constant_feed": constant,
                               "degrees": degrees, "ratio": ratios}, {})


def lines_part():
    """A line at each slope, from zero."""
    text = f"F{FEED:g}\n"
    for degrees in SLOPES:
        angle = math.radians(degrees)
        text += f"G00 X0 Y0\nG01 X{WAY * math.cos(angle):.4f} Y{WAY * math.sin(angle):.4f}\n"
    return text + "M30\n"


def speeds_of_lines(trace):
    """mm/s, by line: from the middle half of its rows."""
    inside = cuts(trace)
    speeds = []
    for line in numpy.unique(trace["line"][inside & (trace["feed_mm_s"] > 0)]):
        rows = numpy.flatnonzero((trace["line"] == line) & (trace["feed_mm_s"] > 0))
        first, last = rows[len(rows) // 4], rows[3 * len(rows) // 4]
        way = math.hypot(trace["x_mm"][last] - trace["x_mm"][first], trace["y_mm"][last] - trace["y_mm"][first])
        speeds.append(way / (trace["t_s"][last] - trace["t_s"][first]))
    return numpy.array(speeds)


def speeds_of_arc(trace):
    """rad/s, in bins of ten degrees of a quadrant."""
    angle = numpy.degrees(numpy.arctan2(trace["y_mm"], trace["x_mm"] + RADIUS))
    inside = cuts(trace)
    instants = numpy.interp(range(0, 91, 10), angle[inside], trace["t_s"][inside])
    return math.radians(10) / numpy.diff(instants)


def measure_runs(tools, data):
    """What runs have along lines and an arc, by either clock, with and without constant feed."""
    columns = {name: [] for name in ("path", "clock", "constant_feed", "method", "degrees", "ratio")}
    arc = f"F{FEED:g}\nG03 X-{RADIUS:g} Y{RADIUS:g} I-{RADIUS:g} J0\nM30\n"
    for clock in ("profile", "paper"):
        for constant in ("on", "off"):
            for method in NAMES:
                chosen = [*settings(method, clock, constant), *AT_ONCE]
                for path, degrees, speeds in (
                        ("line", SLOPES, speeds_of_lines(tools.run(None, chosen, lines_part()))),
                        ("arc", range(5, 90, 10), speeds_of_arc(tools.run(None, chosen, arc)))):
                    for angle, speed in zip(degrees, speeds):
                        row = (path, clock, constant, method, float(angle), speed / speeds[0])
                        for column, value in zip(columns.values(), row):
                            column.append(value)
    write(data / "003_4_runs.csv", columns, {"degrees": 0})


def measure_staircases(tools, data):
    """Positions that follow each other, of one spline by each method, and the spline itself."""
    exact = tools.run(None, ["control.backend=none"], SPLINE)
    every = slice(None, None, 25)
    columns = {"method": ["curve"] * len(exact["x_mm"][every]), "x_mm": list(exact["x_mm"][every]),
               "y_mm": list(exact["y_mm"][every])}
    for method in NAMES:
        trace = tools.run(None, [*settings(method, "paper", "on"), *COARSE], SPLINE)
        places = numpy.column_stack([trace["x_mm"], trace["y_mm"]])
        kept = numpy.concatenate([[True], numpy.any(numpy.diff(places, axis=0) != 0, axis=1)])
        columns["method"] += [method] * kept.sum()
        columns["x_mm"] += list(places[kept, 0])
        columns["y_mm"] += list(places[kept, 1])
    write(data / "003_3.csv", columns, {"x_mm": 3, "y_mm": 3})


def measure_ramp(tools, data):
    times = tools.step_times(RAMP_PART, settings("m-dsm", "paper", "on"))
    # The frequency from a pulse to the one EVERY later.
    kept = times[::EVERY]
    middle = (kept[1:] + kept[:-1]) / 2
    write(data / "003_5.csv", {"t_s": middle, "pulse": EVERY * (numpy.arange(len(middle)) + 0.5),
                               "frequency_hz": EVERY / numpy.diff(kept)}, {"t_s": 5, "pulse": 0, "frequency_hz": 1})


def measure_shapes(tools, data):
    trace = tools.run(INPUT, [*settings("m-dsm", "profile", "on"), "control.backend=none"])
    every = 8
    write(data / "003_7.csv", {"x_mm": trace["x_mm"][::every], "y_mm": trace["y_mm"][::every]}, {})
    lines = (PROGRAMS / INPUT).read_text().splitlines()
    moves = [block for block in tools.blocks(INPUT) if block["kind"] in ("feed", "arc", "nurbs")]
    write(data / "003_table6.csv",
          {"input": [command(lines, block["line"] - 1) for block in moves],
           "block": [block["kind"] for block in moves],
           "end_x_mm": [block["to"][0] for block in moves],
           "end_y_mm": [block["to"][1] for block in moves]}, {})


def command(lines, first):
    """A command without its comment, with the numbers of the lines that follow."""
    last = first + 1
    while last < len(lines) and lines[last].strip()[:1].lstrip("-").isdigit():
        last += 1
    return " ".join(" ".join(line.split(";")[0] for line in lines[first:last]).split())


def measure(tools, data):
    for part in (measure_table, measure_feeds, measure_runs, measure_staircases, measure_ramp, measure_shapes):
        part(tools, data)


def rows(columns, **wanted):
    """The rows in which each of these columns has this value."""
    keep = [all(str(columns[name][i]) == str(value) for name, value in wanted.items())
            for i in range(len(columns["method"]))]
    return {name: [value for value, kept in zip(column, keep) if kept] for name, column in columns.items()}


def draw_staircases(data, out):
    places = read(data / "003_3.csv")
    page, panels = grid(2, 3, size=(10, 6.4))
    exact = rows(places, method="curve")
    for axes, method in zip(panels, NAMES):
        stairs = rows(places, method=method)
        axes.plot(exact["x_mm"], exact["y_mm"], color="#868e96", lw=0.9)
        axes.plot(stairs["x_mm"], stairs["y_mm"], color=OF[method], lw=1.1)
        axes.set(title=f"{NAMES[method]}, {len(stairs['x_mm']) - 1} moves", xlabel="X, mm", ylabel="Y, mm",
                 aspect="equal", xlim=(-2, 62), ylim=(-28, 20))
    panels[-1].axis("off")
    panels[-1].text(0.05, 0.6, "Figure 3: a spline\nby steps of 2 mm;\ngrey: the spline itself", fontsize=11)
    save(page, out / "003_3.svg")


def draw_feeds(data, out):
    feeds, ran = read(data / "003_4.csv"), read(data / "003_4_runs.csv")
    page, panels = figure(2, across=True, size=(9.6, 4.6), sharey=True)
    for axes, path, title in zip(panels, ("line", "arc"), ("(a) lines, over their slope", "(b) arc, over its angle")):
        for method in NAMES:
            for constant in (0, 1):
                curve = rows(feeds, path=path, method=method, constant_feed=float(constant))
                axes.plot(curve["degrees"], curve["ratio"], color=OF[method], lw=WIDTHS[method], ls="-" if constant else "--",
                          label=f"{NAMES[method]}{', compensated' if constant else ''}")
                dots = rows(ran, path=path, method=method, clock="paper", constant_feed=("off", "on")[constant])
                axes.plot(dots["degrees"], dots["ratio"], ".", color=OF[method], ms=5)
        axes.set(title=f"Figure 4{title}", xlabel="degrees", ylim=(0.65, 1.5))
    panels[0].set_ylabel("feed, as part of that at 0 (a), of the first bin (b)")
    legend_below(page, *panels[0].get_legend_handles_labels(), 5)
    save(page, out / "003_4.svg")


def draw_ramp(data, out):
    ramp = read(data / "003_5.csv")
    page, axes = figure(1)
    axes.plot(ramp["t_s"], ramp["frequency_hz"] / 1000, color=COLOURS[0])
    axes.set(title="Figure 5: pulses of a line of 20 mm at F3000, 1000 mm/s²", xlabel="time, s",
             ylabel="pulses per second, thousands", ylim=(0, None))
    save(page, out / "003_5.svg")


def draw_shapes(data, out):
    path, table = read(data / "003_7.csv"), read(data / "003_table6.csv")
    page, (left, right) = figure(2, across=True, size=(9.6, 3.8), width_ratios=[1, 2.2])
    left.axis("off")
    left.text(0, 1, "f 3000\n" + "\n".join(wrapped(line) for line in table["input"]), va="top", family="monospace",
              fontsize=9, transform=left.transAxes)
    left.set_title("Figure 7: input", loc="left")
    right.plot(path["x_mm"], path["y_mm"], color=COLOURS[0], lw=1.1)
    right.set(title="interpolation by M_DSM, BLU 2.5 µm", xlabel="X, mm", ylabel="Y, mm", aspect="equal")
    save(page, out / "003_7.svg")


def wrapped(line):
    words = line.split()
    return line if len(words) < 9 else " ".join(words[:8]) + "\n    " + " ".join(words[8:])


def draw(data, out):
    draw_staircases(data, out)
    draw_feeds(data, out)
    draw_ramp(data, out)
    draw_shapes(data, out)


PAPERS_TABLE_3 = {"sam": ("0.392587", "0.999875"), "m-sam": ("0.302568", "0.999500"),
                  "dda": ("0.306079", "0.999500"), "dsm": ("0.225151", "0.496906"),
                  "m-dsm": ("0.225151", "0.496906")}


def ratio(feeds, path, method, constant, degrees):
    of = rows(feeds, path=path, method=method, constant_feed=constant, degrees=float(degrees))
    return of["ratio"][0]


def compare(data):
    """(figure, what, the paper's, ours) as texts."""
    table = read(data / "003_table3.csv")
    result = []
    for i, method in enumerate(table["method"]):
        mean, most = (f"{table[name][i]:.6f}" for name in ("mean_error_blu", "largest_error_blu"))
        result.append(("Table 3", f"{NAMES[method]}, mean and largest error of R = 4000 BLU, in BLU",
                       ", ".join(PAPERS_TABLE_3[method]), f"{mean}, {most}"))
    feeds = read(data / "003_4.csv")
    off, on = 0.0, 1.0
    most = max(rows(feeds, path="arc", method="m-dsm", constant_feed=off)["ratio"])
    least = min(rows(feeds, path="arc", method="sam", constant_feed=off)["ratio"])
    result += [
        ("4(a)", "feed at 45° before compensation, M_DSM", "+41 %", f"{ratio(feeds, 'line', 'm-dsm', off, 45):.4f}"),
        ("4(a)", "the same, SAM", "a picture", f"{ratio(feeds, 'line', 'sam', off, 45):.4f}"),
        ("4(a)", "least feed after it, M_DSM, at 18°", "near 1", f"{ratio(feeds, 'line', 'm-dsm', on, 18):.4f}"),
        ("4(a)", "largest feed after it, M_DSM, at 45°", "near 1", f"{ratio(feeds, 'line', 'm-dsm', on, 45):.4f}"),
        ("4(b)", "largest difference before it on an arc", "29 %",
         f"+{100 * (most - 1):.0f} % by M_DSM, {100 * (least - 1):.0f} % by SAM"),
    ]
    ramp = read(data / "003_5.csv")
    result.append(("5", "largest pulse rate of F3000", "a picture", f"{ramp['frequency_hz'].max() / 1000:.2f} kHz"))
    return result
