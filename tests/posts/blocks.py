# SPDX-License-Identifier: MIT
"""What `softcnc blocks` prints of a program, as the steps of an expectation, and where the two differ."""
import json
import math
import pathlib
import sys

import numpy as np

from path import PLANES, Step

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "oracle"))
import curves  # noqa: E402

TOLERANCE = 1e-6   # mm, mm/s, s and revolutions per minute
NO_MOVE = 1e-9     # mm
SAMPLES = 65       # of a curve that is compared with an ellipse
COOLANT = {7: "mist", 8: "flood", 9: "off"}
MOVES = ("rapid", "feed", "arc", "nurbs")


def steps(text):
    """The moves, waits and ends of the JSON lines that softcnc prints. Each has the state in force; moves of no length
    and waits of no time are left out."""
    state = {"tool": 0, "rpm": 0, "mist": False, "flood": False, "outputs": {}}
    found = []
    for block in map(json.loads, text.splitlines()):
        if not changed(state, block):
            made = step(block)
            if is_something(made):
                made.state = {**state, "outputs": dict(state["outputs"])}
                found.append(made)
    return found


def is_something(made):
    """Whether a move has a length, and a wait a time."""
    if made.kind in ("rapid", "feed"):
        return math.dist(made.start, made.end) > NO_MOVE
    return made.kind != "dwell" or made.seconds > 0


def changed(state, block):
    """Whether a block is one that only changes the state."""
    kind = block["kind"]
    if kind == "tool":
        state["tool"] = block["tool"]
    elif kind == "spindle":
        state["rpm"] = block["rpm"]
    elif kind == "coolant":
        what = block.get("coolant") or COOLANT[block["code"]]  # named where a code of the machine switches it
        state["mist"] = what == "mist" or state["mist"] and what != "off"
        state["flood"] = what == "flood" or state["flood"] and what != "off"
    elif kind == "output":
        state["outputs"][block["output"]] = block["value"]
    return kind in ("tool", "spindle", "coolant", "output")


def step(block):
    kind = block["kind"]
    if kind not in MOVES:
        return Step(kind, seconds=block.get("duration_s"))
    made = Step(kind, start=block["from"], end=block["to"], feed=block.get("feed_mm_s"))
    if kind == "arc":
        made.plane, made.ccw, made.turns = block["plane"], block["ccw"], block["turns"]
        made.center = tuple(block["center"][axis] for axis in PLANES[made.plane])
    if kind == "nurbs":
        made.curve = {name: block[name] for name in ("degree", "control", "weights", "knots")}
    return made


def difference(expected, found):
    """The first difference of two lists of steps, a text; empty: none."""
    for number, (a, b) in enumerate(zip(expected, found), 1):
        if what := unlike(a, b):
            return f"step {number}: {what}"
    if len(expected) != len(found):
        return f"{len(found)} steps, not {len(expected)}"
    return ""


def unlike(expected, found):
    """In what a step differs from the one expected; empty: in nothing."""
    kind = "nurbs" if expected.kind == "ellipse" else expected.kind
    if found.kind != kind:
        return f"{found.kind} to {found.end}, not {expected.kind} to {expected.end}"
    for name in ("start", "end", "feed", "seconds", "plane", "ccw", "turns"):
        if what := apart(name, getattr(expected, name), getattr(found, name)):
            return what
    if expected.kind == "arc" and (what := apart("center", expected.center, found.center)):
        return what
    if expected.kind == "nurbs" and (what := unlike_curve(expected.curve, found.curve)):
        return what
    if expected.kind == "ellipse" and (what := off_ellipse(expected, found)):
        return what
    return apart("state", expected.state, found.state)


def apart(name, expected, found):
    """A text, if two values are not the same within the tolerance."""
    exact = expected is None or isinstance(expected, (bool, str, dict))
    same = expected == found if exact else (found is not None and np.shape(expected) == np.shape(found) and
                                            np.allclose(expected, found, rtol=0, atol=TOLERANCE))
    return "" if same else f"{name} {found}, not {expected}"


def unlike_curve(expected, found):
    """Knots count by their ratios: a curve stays the same if they are scaled and shifted."""
    for name in ("degree", "control", "weights"):
        if what := apart(name, expected[name], found[name]):
            return what
    a, b = (np.asarray(curve["knots"], float) for curve in (expected, found))
    return apart("knots", (a - a[0]) / (a[-1] - a[0]), (b - b[0]) / (b[-1] - b[0]))


def off_ellipse(expected, found):
    """Every point of the curve lies on the ellipse, and the angle goes from start to end without turning back."""
    a, b, start, sweep = expected.ellipse
    nurbs = curves.Nurbs(**{"degree": found.curve["degree"], "control_points": found.curve["control"],
                            "weights": found.curve["weights"], "knots": found.curve["knots"]})
    points = nurbs.derivatives(np.linspace(nurbs.breaks[0], nurbs.breaks[-1], SAMPLES))[0]
    x, y = ((points[:, i] - expected.center[i]) / half for i, half in ((0, a), (1, b)))
    if (far := float(np.max(np.abs(np.hypot(x, y) - 1)) * max(a, b))) > TOLERANCE:
        return f"{far:.3g} mm off the ellipse"
    if np.ptp(points[:, 2]) > TOLERANCE:
        return "leaves its plane"
    turned = np.unwrap(np.arctan2(y, x))
    if np.any(np.diff(turned) * sweep <= 0):
        return "turns back"
    return apart("swept angle", sweep, float(turned[-1] - turned[0])) or \
        apart("angle at the start", 0.0, float(np.sin((turned[0] - start) / 2)))
