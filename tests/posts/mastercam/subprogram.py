# SPDX-License-Identifier: MIT
"""One subprogram in distances (G91) at three places; one of its arcs goes the long way (R below 0)."""
OPTIONS = ["--dialect", "fanuc"]


def part(p, x, y):
    p.line(z=-2, f=150)
    p.line(x=x + 12, f=600)
    p.ccw(x + 20, y + 8, at=(x + 12, y + 8))
    p.line(y=y + 12)
    p.cw(x + 12, y + 20, at=(x + 12, y + 12))  # three quarters of a circle
    p.line(x, y)
    p.rapid(z=3)


def path(p):
    p.tool(4)
    p.spindle(6000)
    p.rapid(z=25)
    p.rapid(z=3)
    part(p, 0, 0)
    p.rapid(40, 0)
    part(p, 40, 0)
    p.rapid(40, 40)
    part(p, 40, 40)
    p.rapid(z=25)
    p.spindle(0)
    p.home("z")
    p.stopped()
