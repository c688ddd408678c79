# SPDX-License-Identifier: MIT
"""NURBS curves over arrays."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core

Floats = NDArray[np.float64]


class Nurbs:
    """A NURBS curve of degree 1 to 9, by its parameter u or its arc length s (mm)."""

    def __init__(
        self,
        control: ArrayLike,
        knots: ArrayLike,
        weights: ArrayLike = (),
        degree: int = 3,
    ) -> None:
        """Makes a curve of control points (mm, shape (n, 2) or (n, 3)) and n + degree + 1 knots.

        Without weights all are 1. Raises Error.
        """
        points = np.atleast_2d(np.asarray(control, float))
        lists = (np.asarray(values, float).ravel().tolist() for values in (knots, weights))
        self._core = _core.Nurbs(points, degree, *lists)

    @classmethod
    def of_block(cls, block: Mapping[str, Any]) -> Nurbs:
        """Makes the curve of a block of kind "nurbs", as blocks() returns it."""
        return cls(block["control"], block["knots"], block["weights"], block["degree"])

    @property
    def length(self) -> float:
        """Arc length, mm."""
        return self._core.length()

    @property
    def domain(self) -> tuple[float, float]:
        """The first and the last parameter."""
        return self._core.domain()

    @property
    def degree(self) -> int:
        """The degree, 1 to 9."""
        return self._core.degree()

    @property
    def control(self) -> Floats:
        """The control points, mm, shape (n, 3)."""
        return self._core.control()

    @property
    def weights(self) -> Floats:
        """The weights, shape (n,)."""
        return np.array(self._core.weights())

    @property
    def knots(self) -> Floats:
        """The knots, shape (n + degree + 1,)."""
        return np.array(self._core.knots())

    def __repr__(self) -> str:
        return f"<Nurbs of degree {self.degree}, {len(self.control)} points, {self.length:.3f} mm>"

    def __reduce__(self) -> Any:
        return Nurbs, (self.control, self.knots, self.weights, self.degree)

    def point(self, u: ArrayLike) -> Floats:
        """Returns the points at parameters u, mm, shape (len(u), 3)."""
        return self._core.point(np.atleast_1d(np.asarray(u, float)))

    def derivative(self, u: ArrayLike, order: int = 1) -> Floats:
        """Returns the derivatives by u of that order, 1 to 3, shape (len(u), 3)."""
        return self._core.derivative(np.atleast_1d(np.asarray(u, float)), order)

    def curvature(self, u: ArrayLike) -> Floats:
        """Returns the curvature at parameters u, 1/mm, shape (len(u),)."""
        first, second = self.derivative(u, 1), self.derivative(u, 2)
        speed = np.linalg.norm(first, axis=1)
        curvature: Floats = np.linalg.norm(np.cross(first, second), axis=1) / speed**3
        return curvature

    def arc_length(self, u: ArrayLike) -> Floats:
        """Returns the arc length from the start to parameters u, mm, shape (len(u),)."""
        return self._core.arc_length(np.atleast_1d(np.asarray(u, float)))

    def parameter(self, s: ArrayLike) -> Floats:
        """Returns the parameters at arc lengths s, mm, shape (len(s),)."""
        return self._core.parameter(np.atleast_1d(np.asarray(s, float)))

    def g06_2(self, feed: float) -> str:
        """Returns a program of the curve as a G06.2 block; feed in mm/min, above 0.

        The machine goes to its first point by a rapid first.
        """
        if not (0 < feed < np.inf):
            raise ValueError("the feed must be above 0")
        control, weights, knots = self.control, self.weights, [_decimal(k) for k in self.knots]
        lines = ["G21 G90 G17", "G00 " + _place(control[0])]
        for i, point in enumerate(control):
            begin = f"G06.2 P{self.degree + 1} F{_decimal(feed)} " if i == 0 else ""
            lines.append(f"{begin}K{knots[i]} {_place(point)} R{_decimal(weights[i])}")
        lines += [f"K{knot}" for knot in knots[len(control) :]]
        return "\n".join([*lines, "M02", ""])


def _decimal(value: float) -> str:
    """Returns the shortest number that reads back exactly; programs have no exponents."""
    return np.format_float_positional(value, trim="-")


def _place(point: Floats) -> str:
    return " ".join(f"{axis}{_decimal(value)}" for axis, value in zip("XYZ", point))
