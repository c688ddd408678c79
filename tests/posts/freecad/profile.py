# SPDX-License-Identifier: MIT
"""A contour with arcs that name K0.000 across their plane, and every axis in every line."""


def path(p):
    p.tool(2)
    p.spindle(8000)
    p.rapid(z=15)
    p.rapid(-3, 5)
    p.rapid(z=3)
    p.line(z=-2, f=200)
    p.line(y=25, f=400)
    p.cw(5, 33, at=(5, 25))
    p.line(x=45)
    p.cw(53, 25, at=(45, 25))
    p.ccw(58, 20, at=(58, 25))
    p.rapid(z=15)
    p.spindle(0)
    p.stopped()
