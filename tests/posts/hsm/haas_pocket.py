# SPDX-License-Identifier: MIT
"""A round pocket in G154 P9 (no offset), with a helix of one turn, and G187, which changes no path."""
OPTIONS = ["--dialect", "haas"]


def path(p):
    p.tool(12)
    p.spindle(7000)
    p.flood()
    p.rapid(30, 20)
    p.rapid(z=15)
    p.rapid(z=2)
    p.line(z=0.5, f=1000)
    p.ccw(z=-3, at=(25, 20), f=500)
    p.ccw(at=(25, 20))
    p.line(35, f=900)
    p.ccw(15, at=(25, 20))
    p.ccw(35, at=(25, 20))
    p.rapid(z=15)
    p.spindle(0)
    p.dry()
    p.rapid(z=0)
    p.rapid(y=0)
    p.stopped()
