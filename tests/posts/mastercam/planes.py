# SPDX-License-Identifier: MIT
"""Half circles in G18 and G19, up over a cylinder or down into a channel; the centres by I K, J K and R.

G02 and G03 are seen against the axis across the plane. So in G18, where Z is the first axis, G02 from -X to +X goes over
the top; in G19 G03 from -Y to +Y goes below.
"""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(7)
    p.spindle(8000)
    p.rapid(x=-20)
    p.flood()
    p.rapid(z=40)
    p.rapid(z=12)
    p.line(z=0, f=300)
    p.cw(x=20, at=(0, 0), plane="ZX", f=900)
    p.line(y=2)
    p.ccw(x=-20, at=(0, 0), plane="ZX")
    p.rapid(z=40)
    p.rapid(0, -20)
    p.rapid(z=12)
    p.line(z=0, f=300)
    p.ccw(y=20, at=(0, 0), plane="YZ", f=900)
    p.line(x=2)
    p.cw(y=-20, at=(0, 0), plane="YZ")
    p.rapid(z=40)
    p.dry()
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
