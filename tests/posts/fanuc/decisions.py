# SPDX-License-Identifier: MIT
"""A counter in #500, nested loops and jumps, a stop for the operator by #3006, positions and codes read back."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC1032", "SC1036", "SC1037"]


def path(p):
    p.tool(1)
    p.spindle(1500)
    p.rapid(0, 0, 20)
    for part in (3, 2, 1):
        p.rapid(15 * part, 0)
        for depth in (-1, -2, -3):
            p.line(z=depth, f=60 if depth == -2 else 120)
        p.rapid(z=5)
    p.stop()
    p.rapid(15, 7.5)
    for y in (10, 12.5, 15):
        p.rapid(y=y)
    p.spindle(0)
    p.stopped()
