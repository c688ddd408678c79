# SPDX-License-Identifier: MIT
"""G91 for places alone: R and Z of the cycle, given in G90, stay where they are (manual, example of G16 with G91)."""
from path import polar

OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2385"]  # heights kept into G91


def path(p):
    p.tool(2)
    p.spindle(900)
    p.rapid(z=40)
    for hole in range(5):
        p.drill(*polar(60, 20 + 72 * hole), r=3, z=-15, out=3, f=120)
    for x, y in ((0, 0), (7.5, 0), (7.5, 7.5)):
        p.pecks(x, y, r=3, z=-10, q=6, out=3, clearance=0.254, f=100)
    p.rapid(z=40)
    p.spindle(0)
    p.home("z")
    p.stopped()
