# SPDX-License-Identifier: MIT
"""Scan lines in distances (G91) with overscan: power off before and after each, a gap within the second."""
OPTIONS = ["--dialect", "grbl"]
WARNINGS = ["SC2203"]
SCANS = ((5.0, ((3, 0), (23, 300), (24, 0))),
         (5.1, ((23, 0), (14, 300), (12, 0), (3, 300), (2, 0))),
         (5.2, ((3, 0), (23, 300), (24, 0))))  # height, and the ends of its lines with their power


def path(p):
    p.rapid(x=2, y=5)
    for y, ends in SCANS:
        p.rapid(y=y)
        for x, power in ends:
            p.spindle(power)
            p.line(x, f=6000)
    p.rapid(0, 0)
    p.stopped()
