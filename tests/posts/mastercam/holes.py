# SPDX-License-Identifier: MIT
"""Modal cycles whose R, Z and way out change from hole to hole, through two tools."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2121"]  # P of a cycle


def path(p):
    p.tool(2)
    p.spindle(2000)
    p.rapid(15, 15)
    p.flood()
    p.rapid(z=25)
    p.drill(15, 15, r=3, z=-18.4, out=25, f=240)
    p.drill(45, 15, r=3, z=-18.4, out=25)
    p.drill(45, 45, r=3, z=-18.4, out=3)
    p.drill(15, 45, r=1, z=-9, out=1)
    p.dry()
    p.spindle(0)
    p.home("z")
    p.tool(3)
    p.spindle(1200)
    p.rapid(15, 45)
    p.flood()
    p.rapid(z=25)
    for x, y, out in ((15, 45, 3), (45, 45, 3), (45, 15, 3), (15, 15, 25)):
        p.drill(x, y, r=3, z=-2, out=out, f=120, dwell=0.25)
    p.dry()
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
