# SPDX-License-Identifier: MIT
"""G55 is turned by 90 degrees about its origin (40, 10, -5): x = 40 - y', y = 10 + x'. Shifts count before that.

G10 L20 sets an origin by the position; G28 goes to the place of G28.1, via a point if one is given.
"""
WARNINGS = ["SC1039", "SC2122", "SC2134", "SC2269"]


def turned(x, y):
    return 40 - y, 10 + x


def path(p):
    p.rapid(10, 0, 10)
    p.rapid(*turned(10, 5))
    p.line(z=-5, f=400)
    p.ccw(*turned(15, 10), at=turned(10, 10))
    p.line(*turned(15 + 4, 10 + 2))
    p.line(*turned(20, 0))
    p.rapid(-10, 0, 8)
    # There G59.3 gets (1, 2): its origin is (-11, -2).
    p.rapid(-11, -2)
    p.rapid(z=10)  # G28 Z2 in G91: via 8 + 2, which is the place
    p.rapid(10, 0, 10)
    p.rapid(x=5)
    p.rapid(7 + 1, 1)
    p.stopped()
