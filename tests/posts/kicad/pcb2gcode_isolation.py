# SPDX-License-Identifier: MIT
"""Isolation of a pad: S beside G00 without axes, F alone beside G01, dwells of no time, five decimals."""
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.spindle(20000)
    p.dwell(0)
    p.rapid(z=2)
    p.rapid(4.2, 1.15)
    p.line(z=-0.06, f=200)
    p.dwell(0)
    for x, y in ((7.8, 1.15), (8.125, 1.475), (8.125, 3.025), (7.8, 3.35), (4.2, 3.35), (4.2, 1.15)):
        p.line(x, y, f=600)
    p.rapid(z=2)
    p.rapid(12, 1.15)
    p.line(z=-0.06, f=200)
    p.dwell(0)
    p.line(y=6, f=600)
    p.rapid(z=15)
    p.spindle(0)
    p.dwell(1)
    p.stopped()
