# SPDX-License-Identifier: MIT
"""On a machine where lengths without a decimal point count 0.001 mm; feeds and those with a point do not."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(3)
    p.spindle(1200)
    p.rapid(10, -5)
    p.rapid(z=25)
    for x in (10, 30):
        p.pecks(x, -5, r=2, z=-12.5, q=5, out=2, clearance=0.254, f=100)
    p.rapid(z=25)
    p.rapid(50, 0)
    p.line(z=-1.5, f=150)
    p.ccw(60, 10, at=(50, 10))
    p.cw(70, 20, at=(70, 10))
    p.rapid(z=25)
    p.spindle(0)
    p.home("z")
    p.stopped()
