# SPDX-License-Identifier: MIT
"""Lines along a parabola there and back, between switches of the look-ahead that change no path."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(1)
    p.spindle(12000)
    p.flood()
    p.rapid(z=15)
    p.rapid(z=5)
    p.line(z=0, f=500)
    points = [(2.5 * i, -0.25 * i * i) for i in range(5)]
    for x, z in points[1:]:
        p.line(x, z=z, f=2000)
    p.line(y=0.5)
    for x, z in points[3::-1]:
        p.line(x, z=z)
    p.rapid(z=15)
    p.rapid(20, 0)
    p.line(z=-1, f=500)
    p.line(25, 5)
    p.rapid(z=15)
    p.dry()
    p.spindle(0)
    p.home("z")
    p.stopped()
