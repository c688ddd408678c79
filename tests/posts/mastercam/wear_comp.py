# SPDX-License-Identifier: MIT
"""A rounded rectangle with G41 by an offset that the program sets: everything 6 mm to the left, radii 10 + 6.

FANUC's entry ends beside the start of the next move, perpendicular to it; the exit starts beside the end of the last one.
"""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2132", "SC2386"]  # how compensation begins; G10 L12


def path(p):
    p.tool(8)
    p.spindle(2500)
    p.rapid(-20, -20)
    p.rapid(z=25)
    p.rapid(z=5)
    p.line(z=-3, f=200)
    p.line(-16, -10, f=400)
    p.line(y=20)
    p.cw(0, 36, at=(0, 20))
    p.line(x=40)
    p.cw(56, 20, at=(40, 20))
    p.line(y=0)
    p.cw(40, -16, at=(40, 0))
    p.line(x=0)
    p.cw(-16, 0, at=(0, 0))
    p.line(y=5)
    p.line(-20, 5)
    p.rapid(z=25)
    p.spindle(0)
    p.home("z")
    p.stopped()
