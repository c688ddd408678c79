# SPDX-License-Identifier: MIT
"""Whole numbers count mm; G30 alone sends all axes to the second reference point."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(9)
    p.spindle(1000)
    p.rapid(10, 20)
    p.rapid(z=30)
    p.line(z=-2, f=100)
    p.line(60, f=250)
    p.ccw(70, 30, at=(60, 30))
    p.line(y=55)
    p.rapid(z=30)
    p.spindle(0)
    p.home()
    p.stopped()
