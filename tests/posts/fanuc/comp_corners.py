# SPDX-License-Identifier: MIT
"""A pocket, 60 by 40, with the tool 3 mm inside: corners R lose 3 mm of their radius, a chamfer is moved inwards by 3 mm.

The chamfer leads from (6, 40) to (0, 34). Parallel to it, 3 mm inside, runs x - y = -34 + 3 sqrt(2), which meets y = 37
and x = 3.
"""
import math

OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2132", "SC2386"]  # how compensation begins; G10 L12


def path(p):
    p.tool(5)
    p.spindle(3500)
    p.rapid(30, 15)
    p.rapid(z=10)
    p.line(z=-2, f=150)
    p.line(30, 3, f=300)
    p.line(52, 3)
    p.ccw(57, 8, at=(52, 8))
    p.line(57, 35)
    p.ccw(55, 37, at=(55, 35))
    offset = 34 - 3 * math.sqrt(2)  # y = x + offset
    p.line(37 - offset, 37)
    p.line(3, 3 + offset)
    p.line(3, 4)
    p.ccw(4, 3, at=(4, 4))
    p.line(30, 3)
    p.line(30, 15)
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
