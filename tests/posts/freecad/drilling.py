# SPDX-License-Identifier: MIT
"""Cycles with all words in each line, whole numbers written with .0, and a dwell in seconds."""
WARNINGS = ["SC2121"]  # P of a cycle


def path(p):
    p.tool(5)
    p.spindle(1200)
    p.rapid(z=12)
    p.rapid(10, 20)
    p.drill(10, 20, r=3, z=-5, out=3, f=100)
    p.drill(10, 40, r=3, z=-5, out=3, f=100)
    p.drill(30, 20, r=3, z=-1.5, out=3, f=60, dwell=0.5)
    p.pecks(50, 20, r=3, z=-10, q=5, out=3, clearance=0.254, f=80)
    p.pecks(50, 40, r=3, z=-10, q=5, out=3, clearance=0.254, f=80)
    p.rapid(z=12)
    p.spindle(0)
    p.stopped()
