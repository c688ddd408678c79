# SPDX-License-Identifier: MIT
"""Paper 000: a NURBS curve within an allowed chord error (figures 5 to 11)."""
import numpy

from drawing import COLOURS, figure, legend_below, save
from runs import cuts, read, write

PART = "10_paper000_chord_error.nc"
# The paper has no limits of axes.
NO_AXIS_LIMITS = ["axis.x.acceleration_mm_s2=1e6", "axis.y.acceleration_mm_s2=1e6"]
LIMITED = {"005": 0.05, "2": 2.0}  # um, by the names of the files
FIXED = 1000.0  # um: binds nowhere
METHODS = {"plan": "arc-length", "scheme": "curvature3p"}
DENSE = ["control.period_ms=0.05", "control.servo_period_ms=0.05", "control.backend=none"]
# What is kept of a dense run: every so many points.
KEPT = 60
# Starts along the curve, evenly spaced within one step.
STARTS = 64
MAGNIFIED = 100


def runs():
    """(file, tolerance, method) of each run."""
    for name, tolerance in LIMITED.items():
        for kind, method in METHODS.items():
            yield f"000_{kind}_{name}", tolerance, method
    yield "000_fixed", FIXED, "chords"


def measure_starts(tools, data):
    """The chord error of each method over runs that begin elsewhere within one step of the curve."""
    columns = {"run": [], "starts": [], "median_um": [], "worst_um": []}
    for name, tolerance, method in runs():
        settings = [*NO_AXIS_LIMITS, f"control.chord_tolerance_um={tolerance}"]
        row = tools.compare(PART, [method], STARTS, settings)[method]
        for key, value in zip(columns, (name, STARTS, row["chord_error_um_max_median"],
                                        row["chord_error_um_max_worst"])):
            columns[key].append(value)
    write(data / "000_starts.csv", columns, {})


def trace_of(tools, settings):
    trace = tools.run(PART, ["control.backend=none", *settings])
    inside = cuts(trace)
    return {name: column[inside] for name, column in trace.items() if name != "report"}


def chords(trace, dense):
    """For each chord between two rows, the vector from the curve to it where that is longest, um.

    The curve is a run of the same program with far shorter steps, at the same path lengths.
    """
    s, x, y = (dense[name] for name in ("s_mm", "x_mm", "y_mm"))
    ends = numpy.searchsorted(s, trace["s_mm"])
    points = numpy.column_stack([trace["x_mm"], trace["y_mm"]])
    longest = numpy.zeros_like(points)
    for i in range(1, len(points)):
        along = points[i] - points[i - 1]
        size = numpy.hypot(*along)
        if size == 0:
            continue
        normal = numpy.array([-along[1], along[0]]) / size
        between = slice(ends[i - 1], ends[i])
        off = (x[between] - points[i][0]) * normal[0] + (y[between] - points[i][1]) * normal[1]
        if off.size:
            longest[i] = -1000 * off[numpy.argmax(numpy.abs(off))] * normal
    return longest


def curvature_at(dense, lengths):
    """1/mm, at path lengths of a dense run without a column for it: of circles through three points."""
    step = 4
    x, y, s = (dense[name][::step] for name in ("x_mm", "y_mm", "s_mm"))
    ax, ay, bx, by = x[1:-1] - x[:-2], y[1:-1] - y[:-2], x[2:] - x[1:-1], y[2:] - y[1:-1]
    sides = numpy.hypot(ax, ay) * numpy.hypot(bx, by) * numpy.hypot(ax + bx, ay + by)
    with numpy.errstate(invalid="ignore", divide="ignore"):
        curvature = 2 * numpy.abs(ax * by - ay * bx) / sides
    known = numpy.isfinite(curvature)
    return numpy.interp(lengths, s[1:-1][known], curvature[known])


def measure(tools, data):
    measure_starts(tools, data)
    dense = trace_of(tools, DENSE)
    kept = dense["s_mm"][::KEPT]
    curvature = dense["curvature_1_mm"][::KEPT] if "curvature_1_mm" in dense else curvature_at(dense, kept)
    write(data / "000_curve.csv",
          {"s_mm": kept - dense["s_mm"][0], "x_mm": dense["x_mm"][::KEPT], "y_mm": dense["y_mm"][::KEPT],
           "curvature_1_mm": curvature}, {})
    for name, tolerance, method in runs():
        trace = trace_of(tools, [*NO_AXIS_LIMITS, f"control.chord_tolerance_um={tolerance}",
                                 f"control.interpolation={method}"])
        vectors = chords(trace, dense)
        errors = trace.get("chord_error_um", numpy.hypot(*vectors.T))
        errors[0] = 0  # the chord that ends here is that of the move before
        steps = numpy.hypot(numpy.diff(trace["x_mm"], prepend=trace["x_mm"][0]),
                            numpy.diff(trace["y_mm"], prepend=trace["y_mm"][0]))
        columns = {"t_s": trace["t_s"] - trace["t_s"][0], "feed_mm_min": 60 * steps / 0.008,
                   "chord_error_um": errors}
        if name in ("000_scheme_2", "000_fixed"):  # of figure 11
            columns |= {"x_mm": trace["x_mm"], "y_mm": trace["y_mm"], "off_x_um": vectors[:, 0],
                        "off_y_um": vectors[:, 1]}
        write(data / f"{name}.csv", columns,
              {"t_s": 3, "feed_mm_min": 1, "x_mm": 3, "y_mm": 3, "off_x_um": 3, "off_y_um": 3})


def curve_axes(axes, title):
    axes.set(title=title, xlabel="X, mm", ylabel="Y, mm", aspect="equal")


def draw_curve(data, out):
    curve = read(data / "000_curve.csv")
    page, axes = figure(1, size=(5.6, 4.4))
    axes.plot(curve["x_mm"], curve["y_mm"], color=COLOURS[0])
    axes.plot(curve["x_mm"][0], curve["y_mm"][0], "o", color=COLOURS[1])
    i = len(curve["x_mm"]) // 25
    axes.annotate("", (curve["x_mm"][i], curve["y_mm"][i]), (curve["x_mm"][i - 8], curve["y_mm"][i - 8]),
                  arrowprops={"arrowstyle": "->", "color": COLOURS[1], "lw": 1.6})
    axes.annotate("start, clockwise", (curve["x_mm"][0], curve["y_mm"][0]), xytext=(0, 10),
                  textcoords="offset points", ha="center")
    curve_axes(axes, "Figure 5: the curve (here the butterfly)")
    save(page, out / "000_5.svg")
    page, axes = figure(1)
    axes.plot(curve["s_mm"], curve["curvature_1_mm"], color=COLOURS[0], lw=0.9)
    axes.set(title="Figure 7: its curvature", xlabel="path length, mm", ylabel="curvature, 1/mm", yscale="log",
             ylim=(1e-3, 1e2))
    save(page, out / "000_7.svg")


def draw_errors(data, out, number, tolerance):
    name, most = tolerance, LIMITED[tolerance]
    page, (upper, lower) = figure(2, size=(7.2, 5.2), sharex=True)
    for axes, kind, label in ((upper, "scheme", "the paper's scheme (curvature3p)"),
                              (lower, "plan", "softcnc's limit (arc-length)")):
        run = read(data / f"000_{kind}_{name}.csv")
        axes.plot(run["t_s"], run["chord_error_um"], color=COLOURS[kind == "plan"], lw=0.8, label=label)
        axes.axhline(most, color="black", lw=0.8, ls="--", label=f"allowed: {most:g} µm")
        axes.set(ylabel="chord error, µm", ylim=(0, None))
        axes.legend(loc="upper right")
    upper.set_ylim(0, 1.35 * upper.get_ylim()[1])
    lower.set_ylim(0, 1.6 * most)
    upper.set_title(f"Figure {number}: chord error, {most:g} µm allowed (8 ms, F2000)")
    lower.set_xlabel("time, s")
    save(page, out / f"000_{number}.svg")


def draw_feed(data, out):
    page, axes = figure(1)
    for kind, label, width in (("scheme", "the paper's scheme", 0.6), ("plan", "softcnc's limit", 1.0)):
        run = read(data / f"000_{kind}_005.csv")
        axes.plot(run["t_s"], run["feed_mm_min"], color=COLOURS[kind == "plan"], lw=width, label=label)
    axes.set(title="Figure 8: feed, 0.05 µm allowed", xlabel="time, s", ylabel="feed, mm/min", ylim=(0, 2600))
    axes.legend(loc="upper right", ncol=2)
    save(page, out / "000_8.svg")


def draw_fixed(data, out):
    run = read(data / "000_fixed.csv")
    page, axes = figure(1)
    axes.plot(run["t_s"], run["chord_error_um"], color=COLOURS[0], lw=0.8)
    axes.set(title="Figure 10: chord error at a fixed feed of 2000 mm/min", xlabel="time, s",
             ylabel="chord error, µm", ylim=(0, None))
    save(page, out / "000_10.svg")


def draw_magnified(data, out):
    page, both = figure(2, across=True, size=(9.6, 5.0), sharey=True)
    for axes, name, title in zip(both, ("000_scheme_2", "000_fixed"),
                                 ("(a): by the scheme, 2 µm allowed", "(b): at a fixed feed")):
        run = read(data / f"{name}.csv")
        middle = [run[f"{axis}_mm"] - numpy.diff(run[f"{axis}_mm"], prepend=run[f"{axis}_mm"][0]) / 2
                  + MAGNIFIED * run[f"off_{axis}_um"] / 1000 for axis in "xy"]
        axes.plot(run["x_mm"], run["y_mm"], color="#868e96", lw=0.9, label="curve")
        axes.plot(*middle, color=COLOURS[1], lw=0.9, label=f"path, its error {MAGNIFIED} times as large")
        axes.set(title=f"Figure 11{title}", xlabel="X, mm", aspect="equal", xlim=(14, 46), ylim=(4, 36))
    both[0].set_ylabel("Y, mm (the lower left wing)")
    legend_below(page, *both[0].get_legend_handles_labels(), 2)
    save(page, out / "000_11.svg")


def draw(data, out):
    draw_curve(data, out)
    draw_errors(data, out, 6, "005")
    draw_feed(data, out)
    draw_errors(data, out, 9, "2")
    draw_fixed(data, out)
    draw_magnified(data, out)


def over_starts(data, name):
    """The largest chord error of a run in um: the median over its starts, and the worst."""
    starts = read(data / "000_starts.csv")
    row = starts["run"].index(name)
    return starts["median_um"][row], starts["worst_um"][row]


def compare(data):
    """(figure, what, the paper's, ours) as texts."""
    def both(name, form, allowed=None):
        median, worst = over_starts(data, name)
        text = f"{median:{form}}, worst {worst:{form}} µm"
        return text if allowed is None else f"{text}: {median / allowed:.1f} and {worst / allowed:.1f} times"

    fine_run = read(data / "000_plan_005.csv")
    curve = read(data / "000_curve.csv")
    slow = fine_run["feed_mm_min"] < 1990
    return [
        ("5, 7", "largest curvature", "a picture", f"{curve['curvature_1_mm'].max():.1f} /mm"),
        ("6", "chord error by the scheme, 0.05 µm allowed", "within 0.05 µm", both("000_scheme_005", ".3f", 0.05)),
        ("6", "the same by arc-length", "–", both("000_plan_005", ".4f")),
        ("8", "part of the time below F2000, arc-length", "a picture", f"{100 * slow.mean():.0f} %"),
        ("9", "chord error by the scheme, 2 µm allowed", "about 2 µm, irregular", both("000_scheme_2", ".2f", 2)),
        ("9", "the same by arc-length", "–", both("000_plan_2", ".3f")),
        ("10", "chord error at a fixed F2000", "grows with the curvature", both("000_fixed", ".1f")),
    ]
