# SPDX-License-Identifier: MIT
"""Cycles and the tool change written out for grbl, which has neither; their codes stay as comments."""
OPTIONS = ["--dialect", "grbl"]
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.spindle(9000)
    p.rapid(z=5)
    p.rapid(12.5, 7.5)
    p.rapid(z=1)
    p.line(z=-2, f=60)
    p.dwell(0.2)
    p.rapid(z=1)
    p.rapid(x=25)
    p.line(z=-2)
    p.rapid(z=1)
    p.rapid(z=5)
    p.spindle(0)
    p.stopped()
