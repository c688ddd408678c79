# SPDX-License-Identifier: MIT
"""A ramp around a disc in quarter turns of 0.5 mm each, then the last turn level; the end in machine coordinates."""
from path import polar


def path(p):
    p.tool(2)
    p.rapid(z=15)
    p.spindle(14000)
    p.rapid(60, 30)
    p.rapid(z=1)
    p.line(z=0, f=400)
    for quarter in range(1, 7):
        x, y = polar(30, 90 * quarter, (30, 30))
        p.ccw(x, y, -0.5 * quarter, at=(30, 30), f=1200)
    p.ccw(60, 30, -3, at=(30, 30))
    p.ccw(60, 30, at=(30, 30))
    p.rapid(z=15)
    p.rapid(z=0)
    p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
