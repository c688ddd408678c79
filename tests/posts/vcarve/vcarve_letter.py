# SPDX-License-Identifier: MIT
"""Lines in space: a letter carved with a pointed bit."""
POINTS = ((4, 46, -4), (20, 6, -4), (22, 0, 0), (24, 6, -4), (40, 46, -4), (44, 50, 0))


def path(p):
    p.rapid(z=10)
    p.tool(4)
    p.spindle(18000)
    p.rapid(y=50)
    p.rapid(z=2)
    p.line(z=0, f=600)
    for point in POINTS:
        p.line(*point, f=1800)
    p.rapid(z=2)
    p.rapid(z=10)
    p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
