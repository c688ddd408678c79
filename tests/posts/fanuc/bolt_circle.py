# SPDX-License-Identifier: MIT
"""Two bolt circles by one macro: 12 and 5 holes, from their radius and first angle."""
from path import polar

OPTIONS = ["--dialect", "fanuc"]


def circle(p, center, radius, first, count, depth, feed):
    for hole in range(count):
        p.rapid(*polar(radius, first + 360 * hole / count, center))
        p.rapid(z=2)
        p.line(z=depth, f=feed)
        p.rapid(z=2)


def path(p):
    p.tool(1)
    p.spindle(1200)
    p.rapid(z=50)
    circle(p, (40, -25), 30, 15, 12, -8, 150)
    circle(p, (40, -25), 12.5, 0, 5, -5, 90)
    p.rapid(z=50)
    p.spindle(0)
    p.home("z")
    p.stopped()
