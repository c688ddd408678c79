# SPDX-License-Identifier: MIT
"""Holes by G81, G83, G73 and G82, with G98 and G99; P of a cycle is in milliseconds."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2121"]  # P of a cycle
CLEARANCE = 0.254      # of a peck, mm


def path(p):
    p.tool(3)
    p.spindle(2500)
    p.flood()
    p.rapid(10, 10)
    p.rapid(z=15)
    p.rapid(z=10)
    for x, y in ((10, 10), (30, 10), (30, 30)):
        p.drill(x, y, r=5, z=-12, out=10, f=150)
    p.pecks(50, 10, r=5, z=-25, q=9, out=10, clearance=CLEARANCE, f=120)
    p.pecks(70, 10, r=2, z=-8, q=4, out=2, clearance=CLEARANCE, f=180, chip=True)
    p.pecks(70, 30, r=2, z=-8, q=4, out=2, clearance=CLEARANCE, f=180, chip=True)
    p.rapid(z=3)
    p.drill(90, 10, r=3, z=-3, out=3, f=90, dwell=0.5)
    p.rapid(z=15)
    p.spindle(0)
    p.dry()
    p.home("z")
    p.stopped()
