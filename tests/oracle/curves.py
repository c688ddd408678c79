# SPDX-License-Identifier: MIT
"""Curves as softcnc's checks see them: lines, arcs and NURBS by parameter, evaluated without any of its code.

Every curve maps an array of parameters to the position and its first two derivatives by the parameter, arrays of
shape (N, D) in mm; `breaks` are the parameters at which a derivative may jump, the two ends among them.
"""
import json

import numpy as np
from scipy.interpolate import BSpline

GAUSS_NODE, GAUSS_WEIGHT = np.polynomial.legendre.leggauss(16)


class Line:
    """From a to b, by the part of the way: 0 to 1."""

    def __init__(self, a, b):
        self.a, self.b = np.asarray(a, float), np.asarray(b, float)
        self.breaks = np.array([0.0, 1.0])

    def derivatives(self, u):
        u = np.asarray(u, float)[:, None]
        return self.a + u * (self.b - self.a), np.ones_like(u) * (self.b - self.a), np.zeros_like(u * self.a)


class Arc:
    """Around `center` in the plane, by the angle in rad from `start` to `end`."""

    def __init__(self, center, radius, start, end):
        self.center, self.radius = np.asarray(center, float), radius
        self.breaks = np.array([start, end], float)

    def derivatives(self, u):
        c, s = self.radius * np.cos(u), self.radius * np.sin(u)
        return self.center + np.stack([c, s], 1), np.stack([-s, c], 1), np.stack([-c, -s], 1)


class Nurbs:
    """A B-spline of homogeneous coordinates (w x, w y, ..., w), projected; derivatives by the quotient rule."""

    def __init__(self, degree, control_points, weights, knots):
        points, w = np.asarray(control_points, float), np.asarray(weights, float)[:, None]
        knots = np.asarray(knots, float)
        self.homogeneous = BSpline(knots, np.hstack([points * w, w]), degree)
        self.breaks = np.unique(knots[degree:len(points) + 1])
        self.points = points

    def derivatives(self, u):
        u = np.asarray(u, float)
        h = [self.homogeneous(u, nu=order) for order in range(3)]
        w, w1, w2 = (x[:, -1:] for x in h)
        p = h[0][:, :-1] / w
        p1 = (h[1][:, :-1] - w1 * p) / w
        p2 = (h[2][:, :-1] - 2 * w1 * p1 - w2 * p) / w
        return p, p1, p2


def load_nurbs(path):
    """A curve of tests/data."""
    with open(path, encoding="utf-8") as file:
        data = json.load(file)
    return Nurbs(data["degree"], data["control_points"], data["weights"], data["knots"])


def speed(curve, u):
    """|P'|, mm per unit of the parameter."""
    return np.linalg.norm(curve.derivatives(u)[1], axis=1)


def lengths(curve, u0, u1):
    """Arc lengths from u0[i] to u1[i], mm, by Gauss-Legendre quadrature; no break may lie inside."""
    u0, u1 = np.asarray(u0, float), np.asarray(u1, float)
    half = 0.5 * (u1 - u0)
    at = 0.5 * (u0 + u1)[:, None] + half[:, None] * GAUSS_NODE
    return half * (speed(curve, at.ravel()).reshape(at.shape) @ GAUSS_WEIGHT)


def unit_speed(curve, u):
    """Unit tangent and curvature vector: the derivatives of the position by arc length."""
    _, p1, p2 = curve.derivatives(u)
    v = np.linalg.norm(p1, axis=1)[:, None]
    tangent = p1 / v
    along = np.sum(p2 * tangent, axis=1)[:, None]
    return tangent, (p2 - along * tangent) / v**2
