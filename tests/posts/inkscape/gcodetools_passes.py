# SPDX-License-Identifier: MIT
"""Two passes whose depth is computed from variables for scale and offset, in inches."""


def path(p):
    p.spindle(10000)
    p.unit = 25.4
    for depth in (-0.15, -0.25):
        p.rapid(z=0.25)
        p.rapid(1, 1)
        p.line(z=depth, f=8)
        p.line(2, f=20)
        p.line(y=2)
    p.rapid(z=0.25)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
