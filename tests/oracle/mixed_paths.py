# SPDX-License-Identifier: MIT
"""Paths of lines, arcs and NURBS mixed, as contours are: one tangent at every joint, and jumps of curvature."""
import math

import numpy as np

import curves


class Joined:
    """Curves end to end, curve k by the parameters k to k + 1."""

    def __init__(self, parts):
        self.parts = parts
        self.breaks = np.arange(len(parts) + 1.0)

    def derivatives(self, u):
        u = np.asarray(u, float)
        index = np.clip(np.floor(u).astype(int), 0, len(self.parts) - 1)
        out = [np.zeros((len(u), 2)) for _ in range(3)]
        for k in np.unique(index):
            here = index == k
            first, last = self.parts[k].breaks[[0, -1]]
            scale = last - first
            found = self.parts[k].derivatives(first + (u[here] - k) * scale)
            for order, values in enumerate(found):
                out[order][here] = values * scale**order
        return tuple(out)


class Pen:
    """Draws from the origin, each piece from where the last has ended, in its direction."""

    def __init__(self, heading):
        """`heading` in degrees."""
        self.place, self.along = np.zeros(2), direction(math.radians(heading))
        self.curves, self.code = [], []

    def line(self, length):
        end = self.place + length * self.along
        self._add(curves.Line(self.place, end), f"G01 {words('XY', end)}", end, self.along)

    def arc(self, radius, degrees):
        """To the left if `degrees` is positive."""
        sense, turn = math.copysign(1, degrees), math.radians(degrees)
        center = self.place + sense * radius * left_of(self.along)
        first = math.atan2(*(self.place - center)[::-1])
        end = center + radius * direction(first + turn)
        code = f"G0{3 if sense > 0 else 2} {words('XY', end)} {words('IJ', center - self.place)}"
        self._add(curves.Arc(center, radius, first, first + turn), code, end, sense * left_of((end - center) / radius))

    def cubic(self, *points):
        """A NURBS of one span by its further control points, mm ahead and to the left."""
        points = np.array([self.place] + [self.place + a * self.along + b * left_of(self.along) for a, b in points])
        knots = [0, 0, 0, 0, 1, 1, 1, 1]
        code = [f"K{knot} {words('XY', point)}" for knot, point in zip(knots, points)]
        code = ["G06.2 P4 " + code[0], *code[1:], *(f"K{knot}" for knot in knots[4:])]
        ahead = points[3] - points[2]
        self._add(curves.Nurbs(3, points, np.ones(4), knots), "\n".join(code), points[3], ahead / np.linalg.norm(ahead))

    def _add(self, curve, code, end, along):
        self.curves.append(curve)
        self.code.append(code)
        self.place, self.along = end, along


def direction(angle):
    return np.array([math.cos(angle), math.sin(angle)])


def left_of(along):
    return np.array([-along[1], along[0]])


def words(letters, values):
    return " ".join(f"{letter}{value:.9f}" for letter, value in zip(letters, values))


def contour(pen):
    """Corners rounded by arcs of 5 to 10 mm, and a spline between them."""
    pen.line(30)
    pen.arc(5, 90)
    pen.line(20)
    pen.arc(10, 90)
    pen.cubic((10, 0), (15, 15), (25, 15))
    pen.arc(8, 180)
    pen.line(20)


def slalom(pen):
    """Half circles of 2 to 5 mm to either side, with short lines and splines between them."""
    pen.line(3)
    for k in range(4):
        pen.arc(2 + k, 180)
        pen.line(1 + k)
        pen.arc(2.5 + 0.5 * k, -180)
        aside = 1.5 if k % 2 == 0 else -1.5
        pen.cubic((2.5, 0), (3.5, aside), (6, aside))
    pen.line(5)


# Turned, what jumps at a joint and what drives along the path lie on the same axes.
PATHS = {"contour": (contour, 0), "contour, 30°": (contour, 30), "slalom": (slalom, 0), "slalom, 30°": (slalom, 30)}


def draw(name):
    draws, heading = PATHS[name]
    pen = Pen(heading)
    draws(pen)
    return pen
