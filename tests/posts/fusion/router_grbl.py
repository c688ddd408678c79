# SPDX-License-Identifier: MIT
"""A contour with a lead-in arc in G19 and rounded corners, for grbl: no tool change, no dots after whole numbers."""
OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.spindle(12000)
    p.rapid(48.413, 25)
    p.rapid(z=15)
    p.rapid(z=5)
    p.line(z=1, f=333)
    p.line(z=-1.183)
    p.ccw(y=25.317, z=-1.5, at=(25.317, -1.183), plane="YZ")
    p.line(y=30, f=1000)
    p.ccw(43.413, 35, at=(43.413, 30))
    p.line(x=6.588)
    p.ccw(1.588, 30, at=(6.588, 30))
    p.line(y=25)
    p.rapid(z=15)
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
