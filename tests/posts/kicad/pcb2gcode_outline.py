# SPDX-License-Identifier: MIT
"""An outline in two passes with a bridge in the second one, in inches."""
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.unit = 25.4
    p.spindle(15000)
    p.dwell(0.5)
    p.rapid(z=0.07874)
    p.line(z=-0.035, f=4)
    p.line(1, 0, f=10)
    p.line(1, 1)
    p.line(0, 0)
    p.line(z=-0.07, f=4)
    p.line(0.45, f=10)
    p.line(z=-0.03)
    p.line(0.55)
    p.line(z=-0.07, f=4)
    p.line(1, f=10)
    p.line(1, 1)
    p.line(0, 0)
    p.rapid(z=0.07874)
    p.rapid(z=1)
    p.spindle(0)
    p.stopped()
