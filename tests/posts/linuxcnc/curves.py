# SPDX-License-Identifier: MIT
"""A cubic, one that continues it smoothly, a quadratic, a NURBS by control points, and LinuxCNC's form of G6.2."""


def path(p):
    bezier = [0, 0, 0, 0, 1, 1, 1, 1]
    p.nurbs(3, [(0, 0), (2, 4), (8, 4), (10, 0)], bezier, f=900)
    p.nurbs(3, [(10, 0), (12, -4), (18, -4), (20, 0)], bezier)
    p.nurbs(2, [(20, 0), (25, 5), (30, 0)], [0, 0, 0, 1, 1, 1])
    p.nurbs(2, [(30, 0), (40, 10), (50, 0)], [0, 0, 0, 1, 1, 1], [1, 2, 1])
    p.rapid(0, 0)
    p.nurbs(2, [(0, 0), (10, 10), (20, 0)], [0, 0, 0, 1, 1, 1])
    p.line(30)
    p.stopped()
