# SPDX-License-Identifier: MIT
"""A cut in inches that ends with G28 alone: all axes to the reference point."""
OPTIONS = ["--dialect", "grbl"]
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.unit = 25.4
    p.flood()
    p.rapid(0.2, 0.1)
    p.spindle(750)
    for x, y in ((0.5, 0.1), (0.5, 0.3), (0.2, 0.3), (0.2, 0.1)):
        p.line(x, y, f=40)
    p.spindle(0)
    p.dwell(1.5)
    p.home()
    p.dry()
    p.stopped()
