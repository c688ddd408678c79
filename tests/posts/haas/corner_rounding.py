# SPDX-License-Identifier: MIT
"""Chamfer and rounding with blocks that go straight on between them, also in G91, in inches."""
OPTIONS = ["--dialect", "haas"]


def path(p):
    p.unit = 25.4
    p.tool(6)
    p.spindle(3000)
    p.rapid(z=1)
    p.line(z=-0.1, f=15)
    p.line(4.25, 0, f=30)
    p.line(5, 0.75)
    p.line(5, 2.5)
    p.line(5, 3.5)
    p.ccw(4.5, 4, at=(4.5, 3.5))
    p.line(2, 4)
    p.line(1.25, 4)
    p.ccw(1, 3.75, at=(1.25, 3.75))
    p.line(1, 2)
    p.line(0, 0)
    p.rapid(z=1)
    p.spindle(0)
    p.home("z")
    p.stopped()
