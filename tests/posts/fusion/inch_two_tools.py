# SPDX-License-Identifier: MIT
"""Inches: a ramp to and fro, an arc, then a second tool along points of a parabola."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.unit = 25.4
    p.tool(1)
    p.spindle(3820)
    p.flood()
    p.rapid(-0.375, 0.5)
    p.rapid(z=0.6)
    p.rapid(z=0.2)
    p.line(z=0.04, f=30)
    p.line(1.125, z=-0.125)
    p.line(-0.375, z=-0.25)
    p.line(1.125, f=45)
    p.cw(1.625, 0, at=(1.125, 0))
    p.line(y=-0.75)
    p.rapid(z=0.6)
    p.dry()
    p.spindle(0)
    p.tool(7)
    p.spindle(9000)
    p.rapid(2, 0)
    p.line(z=-0.5, f=12.5)
    for step in (1, 2, 3):
        x = step / 16
        p.line(2 + x, round(8 * x * x + 1e-9, 4), round(-0.5 + 4 * x * x - 1e-9, 4), f=60)
    p.rapid(z=0.6)
    p.spindle(0)
    p.home("z")
    p.stopped()
