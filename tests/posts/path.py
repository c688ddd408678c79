# SPDX-License-Identifier: MIT
"""The path that a program must lead to, stated move by move, without any of softcnc's code.

An expectation calls the functions of a Path in the order of the moves. Positions are those of the program, in its units;
`origin` and `unit` lead from them to the machine: machine = origin + unit * position. Feeds are in units per minute.
What an expectation states is worked out by hand or by closed forms from the manuals of the control.
"""
import math
from dataclasses import dataclass, field

PLANES = {"XY": (0, 1), "ZX": (2, 0), "YZ": (1, 2)}  # the axes of a plane, in the order in which it turns


@dataclass
class Step:
    """A move, a wait or an end, with the state in force while it lasts; mm, mm/s, s and revolutions per minute."""
    kind: str                 # rapid, feed, arc, ellipse, nurbs, dwell, stop, end
    start: list = None
    end: list = None
    feed: float = None
    plane: str = None
    center: tuple = None      # along the two axes of the plane
    ccw: bool = None
    turns: int = None         # full turns beyond the first pass
    seconds: float = None
    curve: dict = None        # degree, control, weights and knots of a NURBS
    ellipse: tuple = None     # half axes, angle at the start and sweep, rad
    state: dict = field(default_factory=dict)


class Path:
    def __init__(self):
        self.steps = []
        self.origin, self.unit = [0.0, 0.0, 0.0], 1.0
        self.machine = [0.0, 0.0, 0.0]
        self.f = None
        self.state = {"tool": 0, "rpm": 0, "mist": False, "flood": False, "outputs": {}}

    # What lasts.

    def tool(self, number):
        self.state["tool"] = number

    def spindle(self, rpm):
        """Clockwise above 0, counter-clockwise below."""
        self.state["rpm"] = rpm

    def flood(self):
        self.state["flood"] = True

    def mist(self):
        self.state["mist"] = True

    def dry(self):
        self.state["flood"] = self.state["mist"] = False

    def output(self, name, value):
        self.state["outputs"][name] = value

    # Moves.

    def rapid(self, x=None, y=None, z=None):
        self._move("rapid", self._to(x, y, z))

    def line(self, x=None, y=None, z=None, f=None):
        self._move("feed", self._to(x, y, z), feed=self._feed(f))

    def ccw(self, x=None, y=None, z=None, at=None, f=None, plane="XY", turns=0):
        self._arc(True, (x, y, z), at, f, plane, turns)

    def cw(self, x=None, y=None, z=None, at=None, f=None, plane="XY", turns=0):
        self._arc(False, (x, y, z), at, f, plane, turns)

    def ellipse(self, center, half_axes, start, sweep, f=None):
        """In X Y: center + (a cos t, b sin t) for t from `start` on, over `sweep`, degrees."""
        start, sweep = math.radians(start), math.radians(sweep)
        last = start + sweep
        end = self._to(center[0] + half_axes[0] * math.cos(last), center[1] + half_axes[1] * math.sin(last), None)
        center = tuple(self.origin[i] + self.unit * center[i] for i in (0, 1))
        half_axes = tuple(self.unit * a for a in half_axes)
        self._move("ellipse", end, feed=self._feed(f), center=center, ellipse=(*half_axes, start, sweep))

    def nurbs(self, degree, points, knots, weights=None, f=None):
        """Through control points in X Y at the present height; the first is the position."""
        control = [self._to(x, y, None) for x, y in points]
        curve = {"degree": degree, "control": control, "weights": list(weights or [1.0] * len(points)),
                 "knots": list(knots)}
        self._move("nurbs", control[-1], feed=self._feed(f), curve=curve)

    def home(self, axes="xyz"):
        """A rapid to the reference point, which is 0 in machine coordinates, in some axes."""
        self._move("rapid", [0.0 if axis in axes else at for axis, at in zip("xyz", self.machine)])

    # Canned cycles, as the manuals describe them: over the hole, down to R, the hole, out.

    def drill(self, x, y, r, z, out, f=None, dwell=None):
        self.rapid(x=x, y=y)
        self.rapid(z=r)
        self.line(z=z, f=f)
        if dwell:
            self.dwell(dwell)
        self.rapid(z=out)

    def pecks(self, x, y, r, z, q, out, clearance, f=None, chip=False):
        """G83: out to R after each peck and back to `clearance` above the last; G73 (chip): up by `clearance` only."""
        self.rapid(x=x, y=y)
        self.rapid(z=r)
        depth = r
        while depth - q > z + 1e-9:
            depth -= q
            self.line(z=depth, f=f)
            if not chip:
                self.rapid(z=r)
            self.rapid(z=depth + clearance)
        self.line(z=z, f=f)
        self.rapid(z=out)

    def bore(self, x, y, r, z, out, f=None, dwell=None):
        """G85, G89: out at the feed to R."""
        self.rapid(x=x, y=y)
        self.rapid(z=r)
        self.line(z=z, f=f)
        if dwell:
            self.dwell(dwell)
        self.line(z=out, f=f)

    # Waits and ends.

    def dwell(self, seconds):
        if seconds:
            self._step("dwell", seconds=seconds)

    def stop(self):
        self._step("stop")

    def stopped(self):
        """The end of the program."""
        self._step("end")

    def _step(self, kind, **what):
        state = {**self.state, "outputs": dict(self.state["outputs"])}
        self.steps.append(Step(kind, state=state, **what))

    def _to(self, *words):
        """Machine coordinates; None: the axis stays."""
        return [at if word is None else origin + self.unit * word
                for word, at, origin in zip(words, self.machine, self.origin)]

    def _feed(self, f):
        self.f = self.f if f is None else f
        return self.f * self.unit / 60

    def _move(self, kind, end, **what):
        whole = kind in ("arc", "ellipse", "nurbs")
        if whole or math.dist(end, self.machine) > 1e-9:
            self._step(kind, start=list(self.machine), end=end, **what)
        self.machine = end

    def _arc(self, ccw, to, at, f, plane, turns):
        center = tuple(self.origin[axis] + self.unit * value for axis, value in zip(PLANES[plane], at))
        self._move("arc", self._to(*to), feed=self._feed(f), plane=plane, center=center, ccw=ccw, turns=turns)


def polar(radius, degrees, center=(0.0, 0.0)):
    """A point of a circle."""
    angle = math.radians(degrees)
    return center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)


def fillet(before, corner, after, radius):
    """Where an arc that rounds a corner between two lines begins and ends, and its centre."""
    u = [(c - b) / math.dist(before, corner) for b, c in zip(before, corner)]
    v = [(a - c) / math.dist(corner, after) for a, c in zip(after, corner)]
    turn = math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1])
    length = radius * math.tan(abs(turn) / 2)
    begin = tuple(c - length * d for c, d in zip(corner, u))
    end = tuple(c + length * d for c, d in zip(corner, v))
    side = math.copysign(radius, turn)
    return begin, end, (begin[0] - side * u[1], begin[1] + side * u[0])
