# SPDX-License-Identifier: MIT
"""@ is the distance from the origin of the work system, ^ the angle; what is missing stays as it is."""
from path import polar

WARNINGS = ["SC2122"]
NO_EFFECT = ["line 27: X0", "line 27: Y0"]  # nothing moves after it


def path(p):
    p.origin = [100, 50, 0]
    p.machine = [0.0, 0.0, 0.0]
    p.tool(2)
    p.spindle(1000)
    p.rapid(z=5)
    p.rapid(*polar(30, 0))
    for hole in range(5):
        p.drill(*polar(30, 72 * hole), r=2, z=-4, out=2, f=120)
    p.rapid(z=5)
    p.rapid(*polar(20, 30))
    p.line(z=-1, f=80)
    for corner in range(1, 7):
        p.line(*polar(20, 30 + 60 * corner), f=300)
    p.line(*polar(25, 30))
    p.ccw(*polar(25, 120), at=(0, 0))
    p.rapid(z=5)
    p.spindle(0)
    p.stopped()
