# SPDX-License-Identifier: MIT
"""Taps turn back at the bottom and leave at the feed to R; a bore leaves at the feed, another with the spindle at rest."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2131"]  # how taps go out with G98


def path(p):
    p.tool(4)
    p.spindle(400)
    p.rapid(15, -20)
    p.rapid(z=20)
    for x in (15, 35):
        p.rapid(x=x)
        p.rapid(z=5)
        p.line(z=-10, f=400)
        p.spindle(-400)
        p.line(z=5)
        p.spindle(400)
        p.rapid(z=20)
    p.spindle(0)
    p.tool(5)
    p.spindle(800)
    p.rapid(60, -20)
    p.bore(60, -20, r=2, z=-15, out=2, f=80)
    p.rapid(x=80)
    p.line(z=-15)
    p.spindle(0)
    p.rapid(z=2)
    p.spindle(800)
    p.rapid(z=20)
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
