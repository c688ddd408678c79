# SPDX-License-Identifier: MIT
"""A contour with G41 as it is, mirrored (G51.1) and turned (G68): the path of the tool is mirrored and turned as a whole.

So the mirrored contour has its tool on the right of it, and arcs the other way round.
"""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2132", "SC2386"]  # how compensation begins; G10 L12
NO_EFFECT = ["line 15: X0"]  # of a mirror that is cancelled


def pocket(p, to, flips=False):
    turn = p.cw if flips else p.ccw
    p.rapid(*to(30, 10))
    p.line(z=-2, f=150)
    p.line(*to(30, 2.5), f=300)
    p.line(*to(40, 2.5))
    turn(*to(40, 17.5), at=to(40, 10))
    p.line(*to(20, 17.5))
    turn(*to(20, 2.5), at=to(20, 10))
    p.line(*to(30, 2.5))
    p.line(*to(30, 10))
    p.rapid(z=10)


def path(p):
    p.tool(6)
    p.spindle(3500)
    p.rapid(z=10)
    pocket(p, lambda x, y: (x, y))
    pocket(p, lambda x, y: (-x, y), flips=True)
    p.drill(-60, 10, r=2, z=-3, out=2, f=100)
    p.drill(-60, 20, r=2, z=-3, out=2)
    p.rapid(z=10)
    pocket(p, lambda x, y: (-y, x))
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
