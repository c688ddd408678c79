# SPDX-License-Identifier: MIT
"""G13 and G12 with I alone: down, half a circle out to the side of +X, the circle, half a circle back to the centre.

The tool keeps its radius from the wall: the centre of a tool of radius 4 mm (L12 has its diameter) goes round on a circle of 12 - 4 mm; D00 is none.
"""
OPTIONS = ["--dialect", "haas"]
WARNINGS = ["SC2386"]  # R of G10 L12 is a diameter


def pocket(p, x, y, radius, depth, feed, turn):
    p.line(z=depth, f=feed)
    turn(x + radius, y, at=(x + radius / 2, y))
    turn(at=(x, y))
    turn(x, y, at=(x + radius / 2, y))


def path(p):
    p.tool(3)
    p.spindle(3500)
    p.rapid(20, 20)
    p.rapid(z=10)
    p.line(z=1, f=500)
    pocket(p, 20, 20, 12 - 4, -3, 300, p.ccw)
    p.line(z=1, f=500)
    p.rapid(60, 20)
    pocket(p, 60, 20, 6, -2, 250, p.cw)
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
