# SPDX-License-Identifier: MIT
"""Subprograms in files of another folder (--subprograms), called by M98, M98 with L2 and G65; G28 alone at the end."""
OPTIONS = ["--dialect", "fanuc", "--subprograms", "subprograms"]


def square(p, x):
    p.line(z=-2, f=200)
    for dx, dy in ((10, 0), (10, 10), (0, 10), (0, 0)):
        p.line(x + dx, 20 + dy, f=500)
    p.rapid(z=15)
    p.rapid(x + 15)


def path(p):
    p.tool(8)
    p.spindle(2500)
    p.rapid(z=15)
    p.rapid(20, 20)
    square(p, 20)
    p.rapid(60)
    square(p, 60)
    square(p, 75)
    p.rapid(0, 60)
    p.line(z=-4, f=200)
    p.line(25, f=500)
    p.rapid(z=15)
    p.spindle(0)
    p.home()
    p.stopped()
