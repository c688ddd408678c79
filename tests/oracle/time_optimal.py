#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The shortest time in which a curve can be run, from rest to rest, under limits of the axes.

    tests/oracle/time_optimal.py CURVE.json --feed MM_MIN --acceleration MM_S2
                                 [--velocity MM_MIN] [--chord-um EPS --period-ms T]

Unknown is q = v^2 over the arc length, piecewise linear, so that the acceleration along the path is u = q'/2. On the
stretch between two nodes the rows |x' u + x'' q| <= A of every axis are asked for in its middle, which makes the
error of the grid second order. One pass from the end finds the largest q from which the rest of the path can still be
run, one pass from the start takes it. The grid is doubled until the time stands.
"""
import argparse
import math
import sys
from dataclasses import dataclass

import numpy as np

import curves

STANDS = 2e-5  # relative; the time is final when a grid twice as fine changes it by less


@dataclass(frozen=True)
class Limits:
    """mm, s. Accelerations and velocities per axis; chord 0: no chord cap."""
    feed: float
    acceleration: tuple
    velocity: tuple = (math.inf, math.inf, math.inf)
    chord: float = 0.0
    period: float = 0.0


@dataclass(frozen=True)
class Profile:
    """v^2 at the nodes, and the derivatives of the path in the middles between them."""
    parameter: np.ndarray
    s: np.ndarray
    q: np.ndarray
    middle_tangent: np.ndarray
    middle_bend: np.ndarray

    @property
    def instants(self):
        """When each node is passed, s."""
        v = np.sqrt(self.q)
        return np.concatenate([[0], np.cumsum(2 * np.diff(self.s) / (v[1:] + v[:-1]))])

    @property
    def time(self):
        return float(self.instants[-1])

    @property
    def u(self):
        return 0.5 * np.diff(self.q) / np.diff(self.s)

    def sampled(self, period):
        """s, v and the parameter once per period, and at the end."""
        instants = self.instants
        t = np.append(np.arange(0, self.time, period), self.time)
        i = np.clip(np.searchsorted(instants, t, side="right") - 1, 0, len(self.s) - 2)
        since, v, u = t - instants[i], np.sqrt(self.q[i]), self.u[i]
        s = np.minimum(self.s[i] + v * since + 0.5 * u * since**2, self.s[-1])
        return s, v + u * since, np.interp(s, self.s, self.parameter)

    def axis_acceleration(self):
        """In the middles of the stretches, one column per axis."""
        q = 0.5 * (self.q[1:] + self.q[:-1])
        return self.middle_tangent * self.u[:, None] + self.middle_bend * q[:, None]


class Spacing:
    """Where nodes go: even in a mixture of arc length and the angle by which the tangent turns, span by span."""

    SAMPLES = 4000

    def __init__(self, curve):
        self.spans = []
        for a, b in zip(curve.breaks[:-1], curve.breaks[1:]):
            u = np.linspace(a, b, self.SAMPLES + 1)
            ds = curves.lengths(curve, u[:-1], u[1:])
            tangent, bend = curves.unit_speed(curve, 0.5 * (u[:-1] + u[1:]))
            self.spans.append((u, ds, np.linalg.norm(bend, axis=1) * ds))
        self.length = sum(np.sum(ds) for _, ds, _ in self.spans)
        self.turn = sum(np.sum(turn) for _, _, turn in self.spans)

    def nodes(self, count):
        """About `count` parameters, every break among them."""
        out = []
        for u, ds, turn in self.spans:
            weight = ds / self.length + (turn / self.turn if self.turn > 0 else 0.0)
            density = np.concatenate([[0], np.cumsum(weight)])
            inside = max(8, math.ceil(count * density[-1] / 2))
            out.append(np.interp(np.linspace(0, density[-1], inside, endpoint=False), density, u))
        return np.append(np.concatenate(out), self.spans[-1][0][-1])


def cap(tangent, bend, limits):
    """The largest q at points of the path, whatever happens around them."""
    axes = tangent.shape[1]
    q = np.full(len(tangent), float(limits.feed)**2)
    with np.errstate(divide="ignore"):
        for i in range(axes):
            q = np.minimum(q, (limits.velocity[i] / np.abs(tangent[:, i]))**2)
        if limits.chord > 0:
            rho = 1 / np.linalg.norm(bend, axis=1)
            eps = limits.chord
            step = np.where(rho > eps, 4 * (2 * eps * rho - eps**2), 4 * eps**2)
            q = np.minimum(q, step / limits.period**2)
    return q


class Stretches:
    """The rows of all stretches, |c0 q + c1 u| <= A with q at the left node, solved for u:
    -bound - slope q <= u <= bound - slope q for each axis."""

    def __init__(self, tangent, bend, h, limits):
        acceleration = np.array(limits.acceleration[:tangent.shape[1]])
        c1 = tangent + h[:, None] * bend
        answers = np.abs(c1) > 1e-12
        with np.errstate(divide="ignore", invalid="ignore"):
            self.bound = np.where(answers, acceleration / np.abs(c1), math.inf)
            self.slope = np.where(answers, bend / c1, 0.0)
            self.q_max = np.min(np.where(answers, math.inf, acceleration / np.abs(bend)), axis=1)
        self.h = h
        self._pairs()

    def _pairs(self):
        """A lower bound on u may not lie above an upper one: where the two close in with growing q, q ends."""
        axes = self.bound.shape[1]
        lower = [(-self.bound[:, i], -self.slope[:, i]) for i in range(axes)]
        lower.append((np.zeros(len(self.h)), -0.5 / self.h))  # q at the right node is not negative
        for i in range(axes):
            for p, m in lower:
                closing = m + self.slope[:, i]
                with np.errstate(divide="ignore", invalid="ignore"):
                    end = (self.bound[:, i] - p) / closing
                self.q_max = np.where(closing > 0, np.fmin(self.q_max, end), self.q_max)


def fastest(curve, spacing, count, limits):
    u = spacing.nodes(count)
    h = curves.lengths(curve, u[:-1], u[1:])
    # Just inside each stretch, so that a jump at a break is seen from both sides.
    left, right = (curves.unit_speed(curve, u[:-1] + w * np.diff(u)) for w in (1e-9, 1 - 1e-9))
    middle = curves.unit_speed(curve, 0.5 * (u[:-1] + u[1:]))
    rows = Stretches(*middle, h, limits)
    caps = np.full(len(u), math.inf)
    caps[:-1] = np.minimum(cap(*left, limits), rows.q_max)
    caps[1:] = np.minimum(caps[1:], cap(*right, limits))
    q = forward(backward(caps, rows), rows)
    return Profile(u, np.concatenate([[0], np.cumsum(h)]), q, *middle)


def backward(caps, rows):
    """The largest q at each node from which rest at the end can be reached: q + 2 h u <= k must leave some u."""
    k = caps.tolist()
    k[-1] = 0.0
    reach = (2 * rows.h[:, None] * rows.bound).tolist()
    closing = (1 - 2 * rows.h[:, None] * rows.slope).tolist()
    for i in range(len(k) - 2, -1, -1):
        for r, c in zip(reach[i], closing[i]):
            if c > 0:
                k[i] = min(k[i], (k[i + 1] + r) / c)
    return k


def forward(k, rows):
    """From rest, as much u as every axis allows, but never above k."""
    q = [0.0] * len(k)
    h, bound, slope = rows.h.tolist(), rows.bound.tolist(), rows.slope.tolist()
    for i in range(len(k) - 1):
        u = min(b - m * q[i] for b, m in zip(bound[i], slope[i]))
        q[i + 1] = min(k[i + 1], max(q[i] + 2 * h[i] * u, 0.0))
    return np.array(q)


def optimum(curve, limits, count=8000, most=2_000_000):
    """The time that stands, s, and the profile it comes from."""
    spacing = Spacing(curve)
    profile = fastest(curve, spacing, count, limits)
    while count < most:
        count *= 2
        finer = fastest(curve, spacing, count, limits)
        settled = abs(finer.time - profile.time) < STANDS * finer.time
        profile = finer
        if settled:
            return profile
    raise RuntimeError("the time does not stand on any grid")


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("curve")
    parser.add_argument("--feed", type=float, required=True, help="mm/min")
    parser.add_argument("--acceleration", type=float, required=True, help="mm/s^2, of every axis")
    parser.add_argument("--velocity", type=float, default=math.inf, help="mm/min, of every axis")
    parser.add_argument("--chord-um", type=float, default=0.0)
    parser.add_argument("--period-ms", type=float, default=1.0)
    options = parser.parse_args(arguments)
    limits = Limits(options.feed / 60, (options.acceleration,) * 3, (options.velocity / 60,) * 3,
                    options.chord_um / 1e3, options.period_ms / 1e3)
    profile = optimum(curves.load_nurbs(options.curve), limits)
    print(f"length {profile.s[-1]:.6f} mm, optimum {profile.time:.5f} s on {len(profile.s)} nodes")


if __name__ == "__main__":
    main(sys.argv[1:])
