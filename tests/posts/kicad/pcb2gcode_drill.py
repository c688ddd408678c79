# SPDX-License-Identifier: MIT
"""Two bits with a stop for each; G81 whose X Y stand last, then lines of X Y alone; no G98 and no G99: out to R."""
WARNINGS = ["SC2120", "SC2129"]  # P of a dwell; the way out of cycles


def path(p):
    p.rapid(z=25)
    p.tool(0)
    p.dwell(1)
    p.tool(1)
    p.stop()
    p.spindle(12000)
    p.dwell(1)
    p.rapid(2.54, 2.54)
    for x in (2.54, 5.08, 7.62):
        p.drill(x, 2.54, r=1.5, z=-1.8, out=1.5, f=300)
    p.rapid(z=25)
    p.spindle(0)
    p.dwell(1)
    p.tool(2)
    p.stop()
    p.spindle(12000)
    p.dwell(1)
    p.drill(10.16, 20.32, r=1.5, z=-1.8, out=1.5)
    p.rapid(z=25)
    p.spindle(0)
    p.dwell(1)
    p.stopped()
