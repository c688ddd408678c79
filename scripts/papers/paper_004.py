# SPDX-License-Identifier: MIT
"""Paper 004: the feed that keeps a roughness (figures 3 to 8, 12, 17, Table 1)."""
import math

import numpy
from matplotlib.colors import TwoSlopeNorm

from drawing import COLOURS, figure, legend_below, plt, save
from runs import cuts, read, write

RADIUS, PICK = 5.0, 0.5  # mm
GRIDS = {"": 2.5, "_20": 20}  # um, by the names of the files
STEPS = ["incline_step=0.25", "feed_step=0.025"]
CYLINDER, HILL = "20_paper004_cylinder.nc", "21_paper004_surface.nc"
FIXED, VARIABLE = "22_paper004_part_fixed.nc", "23_paper004_part_variable.nc"
# A target that no feed of these programs exceeds: they run at their F.
ANY = {"H10.67": "H100"}
PLANES = {"4": (10, 0.5), "5": (0, 0.5), "14": (0, 0.33)}  # degrees, mm per tooth
DRAWN, EVERY = ("4", "5"), 13  # of these, every so many points of the grid
# A plane milled by seven passes of 16 mm; the tip begins over X0.
PASSES, LONG = 7, 16.0


def measure_maps(tools, data):
    for name, grid in GRIDS.items():
        write_text(data / f"004_map{name}.csv", tools.rows_of("roughness_map", "rmax", f"grid_um={grid}", *STEPS))
    write_text(data / "004_critical.csv", tools.rows_of("roughness_map", "critical", "feed_step=0.01", "feed_from=0.5"))


def write_text(path, lines):
    path.write_text("".join(",".join(line) + "\n" for line in lines))


def plane(degrees, feed):
    """A program that mills a plane with that inclination and feed per tooth at 6000 rpm."""
    rise = LONG * math.tan(math.radians(degrees))
    return (f"T1 M06\nS6000 M03\nG00 Z{rise + 10:.4f}\n#1=0\no1 repeat [{PASSES}]\n  G00 X0 Y#1\n"
            f"  G01 Z0 F{feed * 2 * 6000:.4f}\n  X{LONG:g} Z{rise:.6f}\n  G00 Z{rise + 10:.4f}\n"
            f"  #1=[#1+{PICK}]\no1 endrepeat\nM05\nM30\n")


def measure_planes(tools, data):
    """What is left of two feeds by two pick-feeds in the midst of a plane, normal to it."""
    columns = {name: [] for name in ("figure", "x_mm", "y_mm", "height_um")}
    summary = {"figure": [], "inclination_deg": [], "feed_mm": [], "rmax_um": []}
    for name, (degrees, feed) in PLANES.items():
        angle = math.radians(degrees)
        middle = (LONG / 2 - RADIUS * math.sin(angle), (PASSES - 1) / 2 * PICK)
        origin = [middle[0] - 1, middle[1] - 1, -1]
        settings = ["control.backend=none", "control.chord_tolerance_um=1000", f"stock.origin_mm={origin}",
                    "stock.x_mm=2", "stock.y_mm=2", "stock.z_mm=8", "stock.grid_um=2.5"]
        cut = tools.surface(HILL, settings, plane(degrees, feed))
        step = float(cut["step_mm"])
        x = step * numpy.arange(cut["heights_mm"].shape[1]) + origin[0]
        y = step * numpy.arange(cut["heights_mm"].shape[0]) + origin[1]
        # The ball touches the plane RADIUS below its centre, normal to it.
        level = RADIUS - RADIUS / math.cos(angle) + x * math.tan(angle)
        above = 1000 * (cut["heights_mm"] + origin[2] - level) * math.cos(angle)
        window = (abs(x - middle[0]) <= feed * math.cos(angle) + step / 2, abs(y - middle[1]) <= PICK + step / 2)
        part = above[window[1]][:, window[0]]
        for j, row in list(enumerate(part))[::EVERY] if name in DRAWN else ():
            for i, height in list(enumerate(row))[::EVERY]:
                values = (name, x[window[0]][i] - middle[0], y[window[1]][j] - middle[1], float(height))
                for column, value in zip(columns.values(), values):
                    column.append(value)
        values = (name, float(degrees), feed, float(numpy.nanmax(cut["rmax_um"])))
        for column, value in zip(summary.values(), values):
            column.append(value)
    write(data / "004_planes.csv", columns, {"x_mm": 3, "y_mm": 3, "height_um": 2})
    write(data / "004_4_5.csv", summary, {"rmax_um": 2})


def slope(trace):
    """Degrees, at each row: from the rows beside it."""
    x, z = numpy.gradient(trace["x_mm"]), numpy.gradient(trace["z_mm"])
    with numpy.errstate(invalid="ignore"):
        return numpy.degrees(numpy.arctan2(z, x))


def first_pass(trace):
    """The rows of the first cutting move that goes along X."""
    inside = cuts(trace) & (trace["v_mm_s"] > 0)
    moves = numpy.unique(trace["block"][inside & (numpy.gradient(trace["x_mm"]) > 0)])
    return inside & (trace["block"] == moves[0])


def measure_cylinder(tools, data):
    """Feed per tooth and Rmax by inclination, at the fixed feed and at the variable one."""
    stock = ["stock.origin_mm=[-14, 0.25, 40]", "stock.x_mm=28", "stock.y_mm=1", "stock.z_mm=12", "stock.grid_um=5"]
    for name, replaced in (("fixed", ANY), ("variable", {})):
        trace = tools.run(CYLINDER, ["control.backend=none"], replace=replaced)
        rows = first_pass(trace)
        angle, feed = slope(trace)[rows], trace["v_mm_s"][rows] / 200
        keep = slice(2, -2)
        write(data / f"004_8_{name}_feed.csv", {"inclination_deg": angle[keep], "feed_mm": feed[keep]}, {})
        cut = tools.surface(CYLINDER, stock, replace=replaced)
        rmax = cut["rmax_um"]
        # The radius of the path of the tip is 50 mm; a region lies where the ball touches.
        middle = -14 + float(cut["region_mm"]) * (numpy.arange(rmax.shape[1]) + 0.5)
        most = numpy.array([numpy.nanmax(column) if numpy.isfinite(column).any() else numpy.nan for column in rmax.T])
        angles = numpy.degrees(numpy.arcsin(-middle / (50 - RADIUS)))
        known = numpy.isfinite(most)
        write(data / f"004_8_{name}_rmax.csv", {"inclination_deg": angles[known], "rmax_um": most[known]}, {"rmax_um": 2})


def measure_hill(tools, data):
    trace = tools.run(HILL, ["control.backend=none"])
    rows = first_pass(trace)
    write(data / "004_12.csv", {"t_s": trace["t_s"][rows] - trace["t_s"][rows][0],
                                "part_of_length": (trace["s_mm"][rows] - trace["s_mm"][rows][0])
                                / numpy.ptp(trace["s_mm"][rows]),
                                "inclination_deg": slope(trace)[rows], "feed_mm_min": 60 * trace["v_mm_s"][rows]},
          {"t_s": 3, "feed_mm_min": 1})


def measure_part(tools, data):
    """Feeds over time, and Table 1: times, and Rmax where the part is level."""
    crest = ["stock.origin_mm=[38.3, 0.15, 5]", "stock.x_mm=2", "stock.y_mm=0.5", "stock.z_mm=8", "stock.grid_um=2.5"]
    table = {"feed": [], "time_s": [], "rmax_um": []}
    for name, part, replaced in (("fixed", FIXED, {}), ("variable", VARIABLE, {}),
                                 ("variable_h3.33", VARIABLE, {"J0.2 H4.24": "J0.2 H3.33"})):
        trace = tools.run(part, ["control.backend=none"], replace=replaced)
        write(data / f"004_17_{name}.csv", {"t_s": trace["t_s"], "feed_mm_min": 60 * trace["v_mm_s"]},
              {"t_s": 3, "feed_mm_min": 0})
        cut = tools.surface(part, crest, replace=replaced)
        for column, value in zip(table.values(), (name, trace["report"]["time_s"], float(numpy.nanmax(cut["rmax_um"])))):
            column.append(value)
    write(data / "004_table1.csv", table, {"time_s": 3, "rmax_um": 2})


def measure(tools, data):
    for part in (measure_maps, measure_planes, measure_cylinder, measure_hill, measure_part):
        part(tools, data)


def grid_of(table, name):
    """Inclinations, feeds, and a column by both."""
    angles, feeds = numpy.unique(table["inclination_deg"]), numpy.unique(table["feed_mm"])
    return angles, feeds, table[name].reshape(len(angles), len(feeds))


def draw_map(data, out, number, name, title):
    angles, feeds, rmax = grid_of(read(data / "004_map.csv"), name)
    page = plt.figure(figsize=(9.6, 4.2), constrained_layout=True)
    solid = page.add_subplot(1, 2, 1, projection="3d")
    a, f = numpy.meshgrid(angles, feeds, indexing="ij")
    solid.plot_surface(a, f, rmax, cmap="viridis", rcount=25, ccount=17, lw=0.2, edgecolor="#495057")
    solid.set(xlabel="inclination, °", ylabel="feed per tooth, mm", title=f"Figure {number}: {title}, µm")
    solid.view_init(28, 35)
    flat = page.add_subplot(1, 2, 2)
    lines = flat.contour(angles, feeds, rmax.T, levels=[6, 8, 10, 12, 14, 16, 18, 20, 22, 24], cmap="viridis")
    flat.clabel(lines, fmt="%g")
    critical = read(data / "004_critical.csv")
    flat.plot(critical["critical_deg"], critical["feed_mm"], "k--", lw=1.2, label="critical inclination (4)")
    flat.axhline(PICK, color="#868e96", lw=0.8)
    flat.set(xlabel="inclination, °", ylabel="feed per tooth, mm", title="lines of equal Rmax, µm",
             xlim=(0, angles[-1]), ylim=(feeds[0], feeds[-1] * 1.01))
    above = flat.secondary_yaxis("right", functions=(lambda mm: mm / PICK, lambda part: part * PICK))
    above.set_ylabel("feed per tooth, pick-feeds")
    flat.legend(loc="lower right")
    save(page, out / f"004_{number}.svg")


def draw_errors(data, out):
    page, panels = figure(2, across=True, size=(9.6, 4.0), sharey=True)
    for axes, name in zip(panels, GRIDS):
        table = read(data / f"004_map{name}.csv")
        angles, feeds, cut = grid_of(table, "zmap_um")
        error = grid_of(table, "paper_um")[2] - cut
        image = axes.contourf(angles, feeds, error.T, levels=numpy.arange(-2.75, 1.51, 0.25), cmap="RdBu_r",
                              norm=TwoSlopeNorm(0, -2.75, 2.75))
        worst = numpy.unravel_index(numpy.argmax(abs(error)), error.shape)
        axes.plot(angles[worst[0]], feeds[worst[1]], "k+", ms=9)
        axes.annotate(f"{error[worst]:+.2f} µm", (angles[worst[0]], feeds[worst[1]]), xytext=(10, -4),
                      textcoords="offset points")
        axes.set(title=f"Figure 6(b): model less Z-map, grid {GRIDS[name]:g} µm", xlabel="inclination, °")
    panels[0].set_ylabel("feed per tooth, mm")
    page.colorbar(image, ax=panels, label="µm")
    save(page, out / "004_6b.svg")


def draw_critical(data, out):
    table = read(data / "004_critical.csv")
    page, axes = figure(1, size=(5.6, 3.6))
    axes.plot(table["feed_per_pick"], table["critical_deg"], color=COLOURS[0])
    axes.set(title="Figure 7: critical inclination, equation (4)", xlabel="feed per tooth, pick-feeds",
             ylabel="critical inclination, °", ylim=(0, 5))
    axes.annotate(f"{table['critical_deg'][-1]:.2f}°", (1, table["critical_deg"][-1]), xytext=(-38, 6),
                  textcoords="offset points")
    save(page, out / "004_7.svg")


def draw_planes(data, out):
    points, summary = read(data / "004_planes.csv"), read(data / "004_4_5.csv")
    for number, title in ((4, "Figure 4(a)"), (5, "Figure 5(a)")):
        rows = points["figure"] == number
        x, y = numpy.unique(points["x_mm"][rows]), numpy.unique(points["y_mm"][rows])
        height = points["height_um"][rows].reshape(len(y), len(x))
        rmax = summary["rmax_um"][summary["figure"] == number][0]
        angle = summary["inclination_deg"][summary["figure"] == number][0]
        page = plt.figure(figsize=(6.4, 4.6), constrained_layout=True)
        solid = page.add_subplot(1, 1, 1, projection="3d")
        solid.plot_surface(*numpy.meshgrid(x, y), height, cmap="viridis", lw=0, rstride=1, cstride=1)
        solid.set(xlabel="along the feed, mm", ylabel="across, mm", zlim=(0, 26),
                  title=f"{title}: {angle:g}°, 0.5 mm per tooth, heights in µm: Rmax {rmax:.2f}")
        solid.set_box_aspect((1, 1, 0.6))
        solid.view_init(38, -60)
        save(page, out / f"004_{number}.svg")


def draw_cylinder(data, out):
    page, panels = figure(2, across=True, size=(9.6, 3.8), sharey=True)
    for axes, name, part in zip(panels, ("fixed", "variable"), "ab"):
        feed, rmax = (read(data / f"004_8_{name}_{what}.csv") for what in ("feed", "rmax"))
        near = abs(feed["inclination_deg"]) < 17
        axes.plot(rmax["inclination_deg"], rmax["rmax_um"], ".", color=COLOURS[1], label="Rmax of regions, µm")
        axes.axhline(10.67, color="black", ls="--", lw=0.8, label="10.67 µm")
        axes.set(title=f"Figure 8({part}): {name} feed", xlabel="inclination, °", ylim=(0, 27), xlim=(-17, 17))
        second = axes.twinx()
        second.plot(feed["inclination_deg"][near], feed["feed_mm"][near], color=COLOURS[0], label="feed per tooth, mm")
        second.set(ylim=(0, 0.6))
        second.grid(False)
        if name == "variable":
            second.set_ylabel("feed per tooth, mm")
            handles = [axes.get_legend_handles_labels(), second.get_legend_handles_labels()]
            legend_below(page, handles[0][0] + handles[1][0], handles[0][1] + handles[1][1], 3)
        else:
            second.set_yticklabels([])
    panels[0].set_ylabel("Rmax, µm")
    save(page, out / "004_8.svg")


def draw_hill(data, out):
    hill = read(data / "004_12.csv")
    page, axes = figure(1)
    axes.plot(hill["part_of_length"], hill["feed_mm_min"], color=COLOURS[0])
    axes.axhline(0.65 * 6000, color="black", ls="--", lw=0.8, label="65 % of F6000")
    axes.set(title="Figure 12: feed along the hill, by the formulas of the paper", xlabel="part of the path's length",
             ylabel="feed, mm/min", ylim=(0, 6600))
    axes.legend(loc="lower center")
    save(page, out / "004_12.svg")


def draw_part(data, out):
    page, panels = figure(3, size=(7.2, 6.0), sharex=True, sharey=True)
    for axes, name, title in zip(panels, ("fixed", "variable", "variable_h3.33"),
                                 ("Figure 17(a): fixed feed", "17(b): variable, what F7000 leaves beside the tip (H4.24)",
                                  "the other reading: equations (5) and (6) for H3.33")):
        run = read(data / f"004_17_{name}.csv")
        axes.plot(run["t_s"], run["feed_mm_min"], color=COLOURS[0], lw=0.8)
        axes.axhline(7000, color="black", lw=0.6, ls="--")
        axes.set_title(title, loc="left", fontsize=10)
        axes.set(ylabel="mm/min", ylim=(0, 15500))
    panels[-1].set_xlabel("time, s (speeds above 7000 are rapids)")
    save(page, out / "004_17.svg")


def draw(data, out):
    draw_map(data, out, "3", "zmap_um", "Rmax by the Z-map")
    draw_map(data, out, "6", "paper_um", "Rmax by the model")
    for part in (draw_errors, draw_critical, draw_planes, draw_cylinder, draw_hill, draw_part):
        part(data, out)


def compare(data):
    """(figure, what, the paper's, ours) as texts."""
    planes = read(data / "004_4_5.csv")
    rmax = dict(zip(planes["figure"], planes["rmax_um"]))
    model = {name: read(data / f"004_map{name}.csv") for name in GRIDS}
    error = {name: numpy.abs(table["paper_um"] - table["zmap_um"]).max() for name, table in model.items()}
    critical = read(data / "004_critical.csv")
    begins = critical["feed_per_pick"][critical["critical_deg"] > 0].min()
    hill, table = read(data / "004_12.csv"), read(data / "004_table1.csv")
    level = {name: read(data / f"004_8_{name}_rmax.csv") for name in ("fixed", "variable")}
    times, left = table["time_s"], table["rmax_um"]
    return [
        ("3, 5", "Rmax at 0°, 0.5 mm per tooth", "24.9 µm", versus(rmax[5], 24.9)),
        ("4", "Rmax at 10°, 0.5 mm per tooth", "10.7 µm", versus(rmax[4], 10.7)),
        ("14", "Rmax at 0°, 0.33 mm per tooth", "10.2 µm", versus(rmax[14], 10.2)),
        ("6(b)", "largest error of the model, grid 2.5 µm", "1.8 µm", f"{error['']:.2f} µm"),
        ("6(b)", "the same, grid 20 µm", "1.8 µm", f"{error['_20']:.2f} µm"),
        ("7", "critical inclination at 0.5 mm per tooth", "4.3°", f"{critical['critical_deg'][-1]:.3f}°"),
        ("7", "feed at which it begins, pick-feeds", "0.53", f"{begins:.2f} (of steps of 0.01)"),
        ("8(a)", "Rmax at the top, fixed feed", "about twice the rest", f"{level['fixed']['rmax_um'].max():.1f} µm"),
        ("8(b)", "largest Rmax, variable feed", "even", f"{level['variable']['rmax_um'].max():.1f} µm for 10.67 µm"),
        ("12", "lowest feed", "65 %", f"{100 * lowest(hill) / 6000:.1f} %"),
        ("Table 1", "time, variable to fixed", f"{38 * 60 + 10} s / {37 * 60 + 23} s = 1.021",
         f"{times[1]:.3f} s / {times[0]:.3f} s = {times[1] / times[0]:.3f}"),
        ("Table 1", "Rmax where it is level, variable to fixed", "4.1 µm / 5.4 µm = 0.76",
         f"{left[1]:.2f} µm / {left[0]:.2f} µm = {left[1] / left[0]:.2f}"),
    ]


def versus(ours, papers):
    return f"{ours:.2f} µm, {100 * (ours / papers - 1):+.1f} %"


def lowest(hill):
    """The lowest feed in the middle half of the path: at its ends the machine is at rest."""
    middle = abs(hill["part_of_length"] - 0.5) < 0.25
    return hill["feed_mm_min"][middle].min()
