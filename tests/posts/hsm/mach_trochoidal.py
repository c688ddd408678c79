# SPDX-License-Identifier: MIT
"""Full circles side by side, each without an end in its block, first in G90, then in G91."""


def path(p):
    p.tool(1)
    p.spindle(9000)
    p.flood()
    p.rapid(0, 3)
    p.rapid(z=15)
    p.rapid(z=2)
    p.line(z=-5, f=400)
    p.ccw(at=(0, 0), f=1500)
    for circle in range(1, 5):
        p.line(1.2 * circle, f=3000)
        p.ccw(at=(1.2 * circle, 0), f=1500)
    p.line(6, f=3000)
    p.ccw(3, 0, at=(6, 0))
    p.line(6, 3, -4.5)
    p.rapid(z=15)
    p.dry()
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
