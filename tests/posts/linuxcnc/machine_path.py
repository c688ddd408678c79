# SPDX-License-Identifier: MIT
"""o<slot> four times, turned by 90 degrees each, from the folder that the machine file names."""
from path import polar


def path(p):
    p.spindle(1000)
    p.rapid(z=5)
    for angle in (0, 90, 180, 270):
        p.line(z=-0.5, f=100)
        p.line(*polar(12, angle), f=400)
        p.rapid(z=5)
        p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
