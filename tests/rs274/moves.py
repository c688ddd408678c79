# SPDX-License-Identifier: MIT
"""What a program does, in machine coordinates, mm and s: what both interpreters' outputs are turned into."""
from dataclasses import dataclass, field

import numpy as np

PLANE_AXES = {"XY": (0, 1), "ZX": (2, 0), "YZ": (1, 2)}  # of each plane, in the order in which it turns


@dataclass(frozen=True)
class State:
    """What is in force beside the path: compared at every move."""
    tool: int = 0                # in the spindle
    spindle: float = 0.0         # turns/min, positive clockwise
    mist: bool = False
    flood: bool = False
    feed_override: bool = True   # whether it counts
    speed_override: bool = True


@dataclass
class Move:
    kind: str                 # rapid, feed, arc, nurbs, dwell
    start: np.ndarray = None  # mm
    end: np.ndarray = None
    feed: float = None        # mm/s
    plane: str = None
    center: np.ndarray = None
    ccw: bool = None
    turns: int = 0            # full turns beyond the first pass
    duration: float = None    # s, of a dwell
    curve: object = None      # of a NURBS: what softcnc gives it by
    points: list = field(default_factory=list)  # of a NURBS: points rs274 would go through, the end last
    line: int = 0             # softcnc's: where the move stands in the program
    call: str = ""            # rs274's: the canonical call
    state: State = State()

    def unlike_state(self, other):
        """The first of what is in force that differs; empty: nothing. Overrides concern cutting moves alone."""
        names = ["tool", "spindle", "mist", "flood"]
        if self.kind not in ("rapid", "dwell"):
            names += ["feed_override", "speed_override"]
        for name in names:
            ours, theirs = getattr(self.state, name), getattr(other.state, name)
            if abs(ours - theirs) > 1e-4:  # rs274 prints four decimals
                return f"{name} {ours}, not {theirs}"
        return ""

    def moves(self):
        """Whether anything changes place or time passes: lines of no length are no moves."""
        if self.kind == "dwell":
            return self.duration > 0
        return self.kind in ("arc", "nurbs") or bool(np.any(np.abs(self.end - self.start) > 1e-9))


@dataclass
class Outcome:
    """What an interpreter makes of a program."""
    accepted: bool
    moves: list
    errors: list  # Error


@dataclass
class Error:
    code: str     # softcnc's code; empty: rs274's
    text: str
    line: str     # of the program
    number: int = 0  # of that line, where it is known
