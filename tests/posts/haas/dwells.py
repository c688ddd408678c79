# SPDX-License-Identifier: MIT
"""P with a decimal point counts seconds, without one milliseconds; G28 alone at the end."""
OPTIONS = ["--dialect", "haas"]
WARNINGS = ["SC2384", "SC2120", "SC2121"]  # the unit of P


def path(p):
    p.tool(7)
    p.spindle(800)
    p.rapid(15, 15)
    p.rapid(z=20)
    p.dwell(2)
    p.drill(15, 15, r=2, z=-2, out=20, f=60, dwell=0.5)
    p.drill(45, 15, r=2, z=-2, out=20, f=60, dwell=0.5)
    p.dwell(0.5)
    p.rapid(70)
    p.bore(70, 15, r=2, z=-6, out=2, f=60)
    p.rapid(z=20)
    p.spindle(0)
    p.home()
    p.stopped()
