# SPDX-License-Identifier: MIT
"""G16: X is the radius, Y the angle; the radius stays if it is left out; in G91 an angle counts from the last one."""
from path import polar

OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2121"]  # P of a cycle


def path(p):
    p.tool(2)
    p.spindle(900)
    p.rapid(z=40)
    for angle in (20, 140, 260):
        p.drill(*polar(60, angle), r=3, z=-15, out=3, f=120)
    p.rapid(z=40)
    for radius, angle in ((35, 45), (35, 135), (45, 225)):
        p.drill(*polar(radius, angle), r=3, z=-2, out=40, f=100, dwell=0.3)
    p.rapid(*polar(25, -30))
    p.line(z=-1, f=80)
    p.line(*polar(25, 30), f=200)
    p.rapid(z=40)
    p.spindle(0)
    p.home("z")
    p.stopped()
