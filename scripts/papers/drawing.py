# SPDX-License-Identifier: MIT
"""How the figures look, and how they become files that are the same every time."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = ["#1f77b4", "#d62728", "#2ca02c", "#b5651d", "#7f7f7f"]

matplotlib.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "softcnc", "font.family": "sans-serif", "font.size": 10,
    "axes.titlesize": 11, "axes.grid": True, "grid.color": "#e9ecef", "legend.framealpha": 0.9,
    "legend.fontsize": 9, "path.simplify": True, "path.simplify_threshold": 0.3})


def figure(count, across=False, size=(7.2, 3.4), **options):
    """A page and its diagrams: one, or several above or beside each other."""
    shape = (1, count) if across else (count, 1)
    return plt.subplots(*shape, figsize=size, constrained_layout=True, **options)


def grid(rows, columns, size):
    """A page with rows of diagrams, and all of them in the order of reading."""
    page, panels = plt.subplots(rows, columns, figsize=size, constrained_layout=True)
    return page, list(panels.flat)


def legend_below(page, handles, labels, columns):
    page.legend(handles, labels, loc="upper center", bbox_to_anchor=(0.5, 0), ncol=columns)


def save(page, file):
    """Writes an SVG without a date, with white behind it."""
    page.savefig(file, facecolor="white", bbox_inches="tight", metadata={"Date": None, "Creator": None})
    plt.close(page)

