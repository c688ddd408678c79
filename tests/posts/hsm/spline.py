# SPDX-License-Identifier: MIT
"""A cubic NURBS in FANUC's form: five control points, one weight, nine knots; then a line from its end."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(1)
    p.spindle(10000)
    p.rapid(z=10)
    p.line(z=-1, f=300)
    p.nurbs(3, [(0, 0), (10, 20), (30, 25), (45, 10), (60, 0)], [0, 0, 0, 0, 1, 2, 2, 2, 2], [1, 1, 2, 1, 1], f=900)
    p.line(70)
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
