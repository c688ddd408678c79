# SPDX-License-Identifier: MIT
"""G95 with a speed that changes, the next tool selected ahead, dwells by X (seconds) and P (milliseconds)."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.tool(2)
    p.spindle(1500)
    p.rapid(10, 10)
    p.rapid(z=20)
    p.drill(10, 10, r=4, z=-8, out=20, f=0.12 * 1500)
    p.drill(20, 10, r=4, z=-8, out=20, f=0.12 * 1500)
    p.spindle(3000)
    p.drill(30, 10, r=4, z=-8, out=20, f=0.12 * 3000)
    p.spindle(0)
    p.tool(3)
    p.spindle(2000)
    p.rapid(30, 30)
    p.rapid(z=1)
    p.line(z=-1, f=150)
    p.dwell(0.5)
    p.dwell(0.75)
    p.line(z=1, f=1000)
    p.rapid(z=20)
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
