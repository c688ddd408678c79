# SPDX-License-Identifier: MIT
"""A pocket with compensation in control: the walls 3 mm to the inside, rounded corners of radius 6 - 3.

The entry leads to the side of the end of the first move, perpendicular to it, as rs274 does it.
"""

WARNINGS = ["SC2132"]  # how compensation begins


def path(p):
    p.tool(1)
    p.spindle(5000)
    p.mist()
    p.rapid(15, 12)
    p.rapid(z=10)
    p.line(z=-2, f=300)
    p.line(18, 5, f=700)
    p.ccw(20, 3, at=(20, 5))
    p.line(x=34)
    p.ccw(37, 6, at=(34, 6))
    p.line(y=24)
    p.ccw(34, 27, at=(34, 24))
    p.line(x=6)
    p.ccw(3, 24, at=(6, 24))
    p.line(y=6)
    p.ccw(6, 3, at=(6, 6))
    p.line(x=20)
    p.ccw(22, 5, at=(20, 5))
    p.line(25, 12)
    p.rapid(z=10)
    p.spindle(0)
    p.dry()
    p.rapid(z=0)
    p.stopped()
