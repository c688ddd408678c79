# SPDX-License-Identifier: MIT
"""Circles under unequal scales are ellipses, as docs/gcode.md says: x/a = cos t, y/b = sin t."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(4)
    p.spindle(5000)
    p.rapid(30, 0)
    p.rapid(z=20)
    p.line(z=-1, f=100)
    p.line(30, 0, f=600)
    p.ellipse((0, 0), (30, 10), 0, 90)
    p.ellipse((0, 0), (30, 10), 90, 90)
    p.line(-15, 0)
    p.ellipse((0, 0), (15, 5), 180, -180)
    p.line(15, 20)
    p.rapid(z=20)
    p.spindle(0)
    p.home("z")
    p.stopped()
