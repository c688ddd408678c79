# SPDX-License-Identifier: MIT
"""Isolation by FlatCAM: F on lines of its own, a stop at the tool change, no M02 at the end."""


def path(p):
    p.rapid(z=15)
    p.tool(1)
    p.stop()
    p.spindle(1000)
    p.rapid(3, 4)
    p.line(z=-0.05, f=60)
    p.line(3, 9, f=120)
    p.line(3.5, 9.5)
    p.line(9)
    p.rapid(z=2)
    p.rapid(1, 1)
    p.line(z=-0.05, f=60)
    p.line(2, f=120)
    p.rapid(z=2)
    p.spindle(0)
    p.rapid(z=15)
    p.rapid(0, 0)
    p.stopped()
