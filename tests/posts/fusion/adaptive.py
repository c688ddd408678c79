# SPDX-License-Identifier: MIT
"""A helix down in half turns, a spiral out of half circles whose radius grows, and a short arc up and away."""
OPTIONS = []


def path(p):
    p.tool(2)
    p.spindle(6000)
    p.rapid(24, 15)
    p.rapid(z=12)
    p.rapid(z=3)
    p.line(z=1, f=1200)
    for half in range(4):
        p.ccw(x=16 if half % 2 == 0 else 24, z=-half, at=(20, 15), f=600)
    p.ccw(x=16, at=(20, 15))
    p.ccw(x=24, at=(20, 15))
    x, radius = 24, 5
    for step, radius in enumerate((5, 6, 7, 8)):
        side = -1 if step % 2 == 0 else 1
        p.ccw(x=x + 2 * side * radius, at=(x + side * radius, 15), f=1200)
        x += 2 * side * radius
    p.ccw(x=12, at=(20, 15))
    p.ccw(x=28, at=(20, 15))
    p.ccw(27.4142, 16.4142, -2.6, at=(27, 15.414))
    p.rapid(z=12)
    p.spindle(0)
    p.rapid(z=0)
    p.stopped()
