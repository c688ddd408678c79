# SPDX-License-Identifier: MIT
"""Inches in G55, a ramp to and fro, arcs by centre and by radius."""


def path(p):
    p.unit = 25.4
    p.tool(3)
    p.spindle(5000)
    p.rapid(z=0.5)
    p.rapid(1, 0.25)
    p.rapid(z=0.05)
    p.line(1.5, z=-0.025, f=20)
    p.line(1.0, z=-0.1)
    p.line(2.0, f=35)
    p.ccw(2.25, 0.5, at=(2, 0.5))
    p.line(y=1)
    p.ccw(2, 1.25, at=(2, 1))
    p.rapid(z=0.5)
    p.spindle(0)
    p.stopped()
