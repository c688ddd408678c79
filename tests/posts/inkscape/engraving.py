# SPDX-License-Identifier: MIT
"""Hatching in distances, then arcs whose centre is a position (G90.1) or a distance (G91.1)."""


def path(p):
    p.tool(1)
    p.spindle(24000)
    p.rapid(z=3)
    p.rapid(0, 0.5)
    p.line(z=-0.2, f=150)
    for x, y in ((30, 0.5), (30, 1), (0, 1), (0, 1.5), (30, 1.5)):
        p.line(x, y, f=900)
    p.rapid(z=3)
    p.rapid(40, 0)
    p.line(z=-0.2, f=150)
    p.ccw(50, 0, at=(45, 0), f=900)
    p.cw(60, 0, at=(55, 0))
    p.cw(50, 0, at=(55, 0))
    p.rapid(z=3)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
