# SPDX-License-Identifier: MIT
"""A rounding of 5 mm between a line along X and a circle of 20 mm about (60, 0), which it meets at a right angle.

The circle of the rounding touches the line from above and the other circle from outside: its centre is 5 above the line
and 20 + 5 from (60, 0).
"""
import math

OPTIONS = ["--dialect", "haas"]


def path(p):
    p.tool(6)
    p.spindle(3000)
    p.rapid(z=10)
    p.line(z=-1, f=150)
    x = 60 - math.sqrt(25 ** 2 - 5 ** 2)
    p.line(x, 0, f=300)
    p.ccw(60 + 20 / 25 * (x - 60), 20 / 25 * 5, at=(x, 5))
    p.cw(60, 20, at=(60, 0))
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
