# SPDX-License-Identifier: MIT
"""Lines with ,R and ,C: arcs tangent to both lines; chamfers whose ends are equally far from the corner."""
import math

from path import fillet

OPTIONS = ["--dialect", "fanuc"]


def chamfer(before, corner, after, size):
    def towards(point):
        return tuple(c + size * (q - c) / math.dist(corner, point) for c, q in zip(corner, point))

    return towards(before), towards(after)


def path(p):
    p.tool(6)
    p.spindle(3000)
    p.rapid(z=20)
    p.line(z=-2, f=150)
    p.line(42, 0, f=400)
    p.ccw(50, 8, at=(42, 8))
    p.line(50, 35)
    p.line(45, 40)
    begin, end, center = fillet((45, 40), (10, 40), (0, 0), 6)
    p.line(*begin)
    p.ccw(*end, at=center)
    p.line(0, 0)
    p.rapid(z=20)
    p.rapid(80, 0)
    p.line(z=-2, f=150)
    begin, end = chamfer((80, 0), (110, 10), (110, 50), 4)
    p.line(*begin, f=400)
    p.line(*end)
    begin, end, center = fillet((110, 10), (110, 50), (80, 0), 5)
    p.line(*begin)
    p.ccw(*end, at=center)
    p.line(80, 0)
    p.rapid(z=20)
    p.spindle(0)
    p.home("z")
    p.stopped()
