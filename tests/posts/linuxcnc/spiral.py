# SPDX-License-Identifier: MIT
"""72 points of a spiral from a loop; P of arcs counts turns; feeds per turn and by inverse time."""
from path import polar

WARNINGS = ["SC1032"]


def path(p):
    p.spindle(10000)
    p.rapid(z=1)
    p.line(z=-0.5, f=1500)
    for point in range(1, 73):
        p.line(*polar(3 * point / 36, 10 * point))
    p.ccw(6, 0, at=(0, 0), turns=1)
    p.cw(-6, 0, 0.5, at=(0, 0), turns=2)
    p.rapid(z=1)
    p.spindle(1000)
    p.line(0, f=100)
    p.line(y=10, f=60)
    p.spindle(0)
    p.stopped()
