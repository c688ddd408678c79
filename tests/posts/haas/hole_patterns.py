# SPDX-License-Identifier: MIT
"""G70, G71 and G72 at a centre and from a hole on; pecks that lessen from I by J to K; a tap that starts the spindle and stops it; a condition before M99."""
from path import polar

OPTIONS = ["--dialect", "haas"]
CHIP = 0.254


def lessening(p, x, y):
    p.rapid(x, y)
    p.rapid(z=2)
    for depth in (-3, -7, -10):  # 5, 4 and 3 mm
        p.line(z=depth, f=100)
        p.rapid(z=2)
        p.rapid(z=depth + CHIP)
    p.line(z=-12, f=100)
    p.rapid(z=20)


def tap(p, x, y):
    p.rapid(x, y)
    p.rapid(z=5)
    p.spindle(400)
    p.line(z=-10, f=500)
    p.spindle(-400)
    p.line(z=5, f=500)
    p.spindle(0)


def path(p):
    p.tool(1)
    p.spindle(1500)
    p.rapid(z=20)
    for hole in range(6):
        p.drill(*polar(30, 30 + 60 * hole), r=2, z=-4, out=20, f=120)
    for hole in range(3):
        lessening(p, 50, 10 + 12.5 * hole)
    p.tool(2)
    p.spindle(0)
    p.rapid(0, 0)
    p.rapid(z=20)
    for hole in range(3):
        tap(p, *polar(30, -30 - 40 * hole))
    p.rapid(z=20)
    p.rapid(x=50)
    p.rapid(z=0)
    p.stopped()
