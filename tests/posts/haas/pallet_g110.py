# SPDX-License-Identifier: MIT
"""Holes in G110, G111 and G129, which are G154 P1, P2 and P20; G80 restores G00."""
OPTIONS = ["--dialect", "haas"]
WARNINGS = ["SC2269"]  # G10 L20


def path(p):
    p.tool(2)
    p.spindle(2200)
    p.origin = [50, 40, 0]
    p.rapid(0, 0)
    p.rapid(z=30)
    p.pecks(5, 5, r=2, z=-10, q=6, out=30, clearance=0.254, f=110)
    p.origin = [150, 40, 0]
    p.rapid(0, 0)
    p.pecks(5, 5, r=2, z=-10, q=6, out=30, clearance=0.254)
    p.origin = [250, 40, -10]
    p.rapid(0, 0, 40)
    p.drill(5, 5, r=2, z=-4, out=2)
    p.drill(25, 5, r=2, z=-4, out=2)
    p.rapid(z=40)
    p.spindle(0)
    p.home("z")
    p.stopped()
