# SPDX-License-Identifier: MIT
"""Facing both ways: arcs into and out of the stock in G18, a half circle between the passes in G17."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(1)
    p.spindle(1500)
    p.flood()
    p.rapid(130, 12.5)
    p.rapid(z=15)
    p.rapid(z=5)
    p.line(z=2, f=500)
    p.ccw(x=128, z=0, at=(2, 128), plane="ZX")
    p.line(x=-28)
    p.cw(y=37.5, at=(-28, 25))
    p.line(x=128)
    p.cw(x=130, z=2, at=(2, 128), plane="ZX")
    p.rapid(z=15)
    p.spindle(0)
    p.dry()
    p.home("z")
    p.home("xy")
    p.stopped()
