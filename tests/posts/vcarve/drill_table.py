# SPDX-License-Identifier: MIT
"""Rows of holes: one hole a line, then one line repeated (L3) in G91, where R counts from the start and Z from R."""
WARNINGS = ["SC2129"]


def path(p):
    p.tool(5)
    p.rapid(z=25)
    p.spindle(3000)
    p.rapid(20, 20)
    for y in (20, 52, 84):
        p.pecks(20, y, r=2, z=-12, q=5, out=2, clearance=0.254, f=300)
    p.rapid(z=25)
    p.rapid(70, 84)
    for y in (52, 20, -12):
        p.drill(70, y, r=2, z=-8, out=2)
    p.rapid(z=25)
    p.spindle(0)
    p.stopped()
