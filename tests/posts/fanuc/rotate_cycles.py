# SPDX-License-Identifier: MIT
"""Cycles rotated about a point of the part, then arcs by radius and by centre rotated about the origin."""
import math

OPTIONS = ["--dialect", "fanuc"]


def turned(x, y, center, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    dx, dy = x - center[0], y - center[1]
    return center[0] + c * dx - s * dy, center[1] + s * dx + c * dy


def path(p):
    p.tool(3)
    p.spindle(1500)
    p.rapid(z=30)
    for x, y in ((30, 20), (50, 20), (50, 35)):
        p.drill(*turned(x, y, (30, 20), 30), r=2, z=-6, out=2, f=200)
    p.rapid(z=30)

    def at(x, y):
        return y, -x  # by -90 degrees

    p.rapid(*at(10, 5))
    p.line(z=-1, f=100)
    p.cw(*at(20, 15), at=at(20, 5), f=250)
    p.cw(*at(30, 5), at=at(20, 5))
    p.rapid(z=30)
    p.rapid(0, 0)
    p.spindle(0)
    p.home("z")
    p.stopped()
