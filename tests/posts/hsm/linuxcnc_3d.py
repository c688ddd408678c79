# SPDX-License-Identifier: MIT
"""Path modes G64, G61 and G61.1 between moves, arcs in G18, a half circle of a helix by radius, in G56.

In G18 Z is the first axis: the quarter from -X to below the centre goes from Z towards -X, which is clockwise.
"""
WARNINGS = ["SC2133"]  # G61


def path(p):
    p.tool(1)
    p.spindle(8000)
    p.mist()
    p.rapid(-30, 0)
    p.rapid(z=20)
    p.rapid(z=5)
    p.cw(x=-25, z=0, at=(5, -25), plane="ZX", f=800)
    p.cw(x=-20, z=5, at=(5, -25), plane="ZX")
    p.line(-15, z=6)
    p.line(-10, z=5.5)
    p.line(-5.5, z=5.25)
    p.ccw(-5.5, 11, 3.25, at=(-5.5, 5.5))
    p.rapid(z=20)
    p.spindle(0)
    p.dry()
    p.rapid(z=0)
    p.stopped()
