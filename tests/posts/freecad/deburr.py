# SPDX-License-Identifier: MIT
"""Feeds by inverse time between feeds per minute, both coolants, a full circle that names its end."""
import math


def path(p):
    p.tool(8)
    p.spindle(10000)
    p.mist()
    p.flood()
    p.rapid(z=5)
    p.rapid(y=-2.5)
    p.line(z=-0.5, f=500)
    p.line(20, f=20 * 30)
    p.ccw(22.5, 0, at=(20, 0), f=math.pi / 2 * 2.5 * 60)
    p.ccw(at=(20, 0), f=2 * math.pi * 2.5 * 20)
    p.line(y=10, f=500)
    p.rapid(z=5)
    p.dry()
    p.spindle(0)
    p.stopped()
