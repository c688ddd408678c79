# SPDX-License-Identifier: MIT
"""M3 S as the angle of a servo, a dwell after each, and G92 with G92.1 between."""
OPTIONS = ["--dialect", "grbl"]
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.spindle(90)
    p.dwell(0.3)
    p.rapid(12.5, 8)
    p.spindle(30)
    p.dwell(0.2)
    p.line(20, f=2400)
    p.line(20.75, 9.25)
    p.cw(25, 13.5, at=(25, 9.25))
    p.spindle(90)
    p.dwell(0.3)
    p.rapid(30, 8.5)
    p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
