# SPDX-License-Identifier: MIT
"""One shape as it is, half as large about a corner, mirrored in one axis, in both, and by a negative scale.

A mirror in one axis changes the direction of arcs, one in both does not. P and I J K without a point count thousandths.
"""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2253"]  # a scale written as a whole number
NO_EFFECT = ["line 15: X0", "line 18: X0", "line 18: Y0", "line 19: X0"]  # of mirrors that are cancelled; a centre with the factor 1


def shape(p, to, flips=False):
    ccw, cw = (p.cw, p.ccw) if flips else (p.ccw, p.cw)
    p.rapid(*to(10, 10))
    p.line(*to(30, 10), f=300)
    ccw(*to(40, 20), at=to(30, 20))
    p.line(*to(40, 30))
    # Clockwise from (40, 30) to (30, 40) with a radius of 10, the short way: around (40, 40).
    cw(*to(30, 40), at=to(40, 40))
    p.line(*to(10, 10))


def path(p):
    p.tool(4)
    p.spindle(4000)
    p.rapid(z=20)
    p.rapid(z=-1)
    shape(p, lambda x, y: (x, y))
    shape(p, lambda x, y: (10 + (x - 10) / 2, 10 + (y - 10) / 2))
    shape(p, lambda x, y: (-x, y), flips=True)
    shape(p, lambda x, y: (-x, -y))
    shape(p, lambda x, y: (x, -y), flips=True)
    p.rapid(z=20)
    p.spindle(0)
    p.home("z")
    p.stopped()
