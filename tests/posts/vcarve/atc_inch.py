# SPDX-License-Identifier: MIT
"""Inches, two tools, modal lines of one axis, full circles whose end is named."""


def path(p):
    p.unit = 25.4
    p.tool(2)
    p.spindle(16000)
    p.rapid(2, 2)
    p.rapid(z=0.25)
    p.line(z=-0.125, f=40)
    p.line(x=10, f=120)
    p.line(y=8)
    p.line(x=2)
    p.line(y=2)
    p.rapid(z=0.75)
    p.spindle(0)
    p.tool(3)
    p.spindle(18000)
    p.rapid(6, 5)
    p.rapid(z=0.25)
    p.line(z=-0.25, f=30)
    p.cw(6, 5, at=(6.5, 5), f=90)
    p.cw(6, 5, at=(7, 5))
    p.rapid(z=0.75)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
