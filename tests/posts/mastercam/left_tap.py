# SPDX-License-Identifier: MIT
"""Taps with the spindle counter-clockwise, a bore with a dwell and out at the feed; lines that begin with / are left out."""
OPTIONS = ["--dialect", "fanuc", "--block-skip"]
WARNINGS = ["SC2121"]  # P of a cycle


def path(p):
    p.tool(9)
    p.spindle(-300)
    p.rapid(12, -8)
    p.rapid(z=25)
    for x in (12, 36):
        p.rapid(x)
        p.rapid(z=5)
        p.line(z=-14, f=300)
        p.spindle(300)
        p.line(z=5)
        p.spindle(-300)
    p.rapid(z=25)
    p.spindle(0)
    p.home("z")
    p.tool(10)
    p.spindle(500)
    p.rapid(60, -8)
    p.rapid(z=25)
    p.bore(60, -8, r=3, z=-20, out=3, f=75, dwell=0.2)
    p.rapid(z=25)
    p.spindle(0)
    p.home("z")
    p.stopped()
