# SPDX-License-Identifier: MIT
"""Your own interpolation methods along a curve, judged as `softcnc compare` judges its own."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from ._nurbs import Floats, Nurbs
from ._runs import Trace

#: Takes the curve, the parameter u and the distance ds (mm) of a step; returns the next parameter.
Step = Callable[[Nurbs, float, float], float]


@dataclass(frozen=True)
class Walk:
    """Where a method has been on a curve, and how well it kept feed and path."""

    u: Floats  #: parameter of each row, shape (rows,)
    position: Floats  #: mm, shape (rows, 3)
    chord_error_um: Floats  #: of the chord from the row before, um, shape (rows,)
    feed_fluctuation: Floats  #: arc length over planned distance, minus 1, shape (rows,)

    @property
    def chord_error_um_max(self) -> float:
        """The largest chord error, um."""
        return float(np.max(self.chord_error_um))

    @property
    def feed_fluctuation_max(self) -> float:
        """The largest fluctuation without its sign, over steps of more than 1 um."""
        return float(np.nanmax(np.abs(self.feed_fluctuation), initial=0.0))


def walk(curve: Nurbs, plan: Trace, step: Step) -> Walk:
    """Lets a method follow a plan along a curve, as the methods of softcnc do.

    plan: a plan that ends with this curve, as plan(curve.g06_2(feed)) returns it.
    step: a function that returns the next parameter. Whatever it raises is raised. It is given what
        the plan advances in a period from where the method is, so that a method that falls behind
        has the speed of the place where it is.

    The fluctuation is that of `compare`: the arc length of the exact curve between two rows over the
    planned distance, minus 1, where that exceeds 1 um. It is NaN in the first row and in the last
    two periods. The chord error is the largest distance of the chord from the curve, at 16 places of
    each step.
    """
    profile = _Profile(plan, curve.length)
    first, last = curve.domain
    parameters, planned = [first], [np.nan]
    while parameters[-1] < last and len(parameters) < 2 * len(plan) + 2:
        at, s = parameters[-1], float(curve.arc_length(parameters[-1])[0])
        ds = profile.after(s) - s
        planned.append(ds if profile.moves_on(s + ds) else np.nan)
        to = float(step(curve, at, ds)) if ds > 0 else last
        if not np.isfinite(to):
            raise ValueError(f"the method returned {to} from {at}")
        parameters.append(min(max(to, at), last))
    u, position = np.array(parameters), curve.point(parameters)
    ds_planned = np.array(planned)
    moved = np.append(np.nan, np.diff(curve.arc_length(u)))
    fluctuation = np.where(ds_planned > 1e-3, moved / ds_planned - 1, np.nan)
    return Walk(u, position, _chord_errors(curve, u, position), fluctuation)


class _Profile:
    """The planned distance along a curve over time: between rows, the cubic with their speeds."""

    def __init__(self, plan: Trace, length: float) -> None:
        if len(plan) < 3 or not {"t_s", "s_mm", "v_mm_s"} <= set(plan.columns):
            raise ValueError("a plan of three rows or more with t_s, s_mm and v_mm_s is needed")
        s = plan.s_mm - (plan.s_mm[-1] - length)
        begin = int(np.searchsorted(s, 0.0))
        self._s, self._v = s[begin:], plan.v_mm_s[begin:]
        self._period = float(plan.t_s[1] - plan.t_s[0])

    def after(self, s: float) -> float:
        """Returns where the plan is a period after it has been at s, mm."""
        row = int(np.searchsorted(self._s, s, side="right")) - 1
        if row < 0:
            return float(self._s[0])
        if row + 2 >= len(self._s):
            return float(self._s[-1])
        low, high = 0.0, 1.0
        for _ in range(50):
            part = 0.5 * (low + high)
            low, high = (part, high) if self._at(row, part) < s else (low, part)
        return self._at(row + 1, low)

    def moves_on(self, s: float) -> bool:
        """Returns whether the plan still moves a period later."""
        return len(self._s) > 2 and s < float(self._s[-3])

    def _at(self, row: int, part: float) -> float:
        """Returns the distance at a part of the period after a row, mm."""
        a, b = self._s[row], self._s[row + 1]
        p, q = self._v[row] * self._period, self._v[row + 1] * self._period
        cubic = a + part * (p + part * (3 * (b - a) - 2 * p - q + part * (p + q - 2 * (b - a))))
        return float(cubic)


def _chord_errors(curve: Nurbs, u: Floats, position: Floats) -> Floats:
    """Returns the distance of each chord from the curve, um."""
    errors = np.zeros(len(u))
    chord = np.diff(position, axis=0)
    square = np.maximum(np.sum(chord * chord, axis=1), 1e-30)
    for part in np.linspace(0, 1, 18)[1:-1]:
        off = curve.point(u[:-1] + part * np.diff(u)) - position[:-1]
        along = np.clip(np.sum(off * chord, axis=1) / square, 0, 1)
        distance = np.linalg.norm(off - along[:, None] * chord, axis=1)
        errors[1:] = np.maximum(errors[1:], 1e3 * distance)
    return errors
