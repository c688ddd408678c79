# SPDX-License-Identifier: MIT
"""A plate counter-clockwise with the tool of 4 mm on the right: corners become arcs; then a slot on the left.

The entry ends beside the end of the first move, perpendicular to it; at the next line, which turns by 90 degrees, the
tool goes round that point.
"""
WARNINGS = ["SC2130", "SC2132"]  # G41 without D; how compensation begins


def path(p):
    p.tool(1)
    p.spindle(4000)
    p.rapid(20, -20)
    p.rapid(z=2)
    p.line(z=-2, f=500)
    # Entry along +Y, right side: beside (20, 0) at (24, 0). The next line, to +X, turns to the right: the tool is inside
    # of this corner, and its two lines meet 4 mm beside both.
    p.line(24, -4)
    p.line(40, -4)
    p.ccw(44, 0, at=(40, 0))
    p.line(y=30)
    p.ccw(40, 34, at=(40, 30))
    p.line(x=0)
    p.ccw(-4, 30, at=(0, 30))
    p.line(y=0)
    p.ccw(0, -4, at=(0, 0))
    p.line(x=20)
    p.line(20, -20)
    p.rapid(z=2)
    p.spindle(0)
    p.tool(3)
    p.spindle(6000)
    p.rapid(70, 20)
    p.line(z=-2)
    # Entry along +Y, left side; the line to -X turns to the left, towards the tool: an inside corner.
    p.line(67.5, 27.5)
    p.line(60, 27.5)
    p.ccw(60, 12.5, at=(60, 20))
    p.line(80, 12.5)
    p.ccw(80, 27.5, at=(80, 20))
    p.line(70, 27.5)
    p.line(70, 20)
    p.rapid(z=2)
    p.spindle(0)
    p.stopped()
