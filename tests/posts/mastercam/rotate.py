# SPDX-License-Identifier: MIT
"""A slot at 0, 60 and 120 degrees by G68: rotation about (0, 0), arcs keep their radius and direction."""
import math

OPTIONS = ["--dialect", "fanuc"]


def slot(p, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))

    def turned(x, y):
        return c * x - s * y, s * x + c * y

    p.rapid(*turned(20, -3))
    p.rapid(z=2)
    p.line(z=-4, f=200)
    p.line(*turned(35, -3), f=500)
    p.ccw(*turned(35, 3), at=turned(35, 0))
    p.line(*turned(20, 3))
    p.rapid(z=2)


def path(p):
    p.tool(5)
    p.spindle(4000)
    p.rapid(z=30)
    for degrees in (0, 60, 120):
        slot(p, degrees)
    p.rapid(z=30)
    p.spindle(0)
    p.home("z")
    p.stopped()
