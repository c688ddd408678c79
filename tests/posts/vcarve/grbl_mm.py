# SPDX-License-Identifier: MIT
"""A round pocket in rings, for grbl: modal arcs in quarters, then in halves; T without a change of tools."""
from path import polar

OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.rapid(z=6)
    p.spindle(12000)
    p.rapid(30, 20, 2)
    p.line(z=-1.5, f=300)
    for quarter in range(1, 5):
        x, y = polar(5, 90 * quarter, (25, 20))
        p.ccw(x, y, at=(25, 20), f=900)
    p.line(x=33)
    p.ccw(x=17, at=(25, 20))
    p.ccw(x=33, at=(25, 20))
    p.rapid(z=6)
    p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
