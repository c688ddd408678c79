# SPDX-License-Identifier: MIT
"""Work systems by G10 L2 and by a variable, G52, G92, a length with wear, machine coordinates by G53.

machine = origin + shift + length + program. G54 is at (100, 50, 0), G56 at (-20, -10, -5), then at (20, -10, -5); the
length is 62.5 - 0.5.
"""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC1036", "SC1039", "SC2123", "SC2126", "SC2134"]


def path(p):
    p.tool(4)
    p.spindle(1000)
    p.rapid(100, 50)
    p.rapid(z=72)
    p.rapid(100 + 5 + 10, 50 + 2 + 10)
    p.line(z=62, f=100)
    p.line(110, 60)
    p.line(110 + 3, 60 + 4)
    p.rapid(-20 + 10, -10 + 10)
    p.rapid(20 + 10, z=-5 + 62 + 62)
    p.rapid(z=-1)
    p.rapid(1, 1)
    p.spindle(0)
    p.stopped()
