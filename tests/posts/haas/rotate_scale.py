# SPDX-License-Identifier: MIT
"""A window as it is, twice as large about its corner, turned by 45 degrees about it, and both: R scales along."""
import math

OPTIONS = ["--dialect", "haas"]


def window(p, scale=1.0, degrees=0.0, about=(0.0, 0.0)):
    c, s = scale * math.cos(math.radians(degrees)), scale * math.sin(math.radians(degrees))

    def to(x, y):
        dx, dy = x - about[0], y - about[1]
        return about[0] + c * dx - s * dy, about[1] + s * dx + c * dy

    p.rapid(*to(10, 10))
    p.line(*to(20, 10), f=400)
    p.line(*to(20, 20))
    p.ccw(*to(10, 20), at=to(15, 20))
    p.line(*to(10, 10))


def path(p):
    p.tool(5)
    p.spindle(6000)
    p.rapid(z=10)
    p.line(z=-1, f=200)
    window(p)
    window(p, scale=2, about=(10, 10))
    window(p, degrees=45, about=(10, 10))
    window(p, scale=1.5, degrees=180)
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
