# SPDX-License-Identifier: MIT
"""The same hole in G54, G55, G54.1 P1 and G54.1 P48, whose origins the program sets by G10 L2 and L20."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC2269"]  # G10 L20


def path(p):
    p.tool(6)
    p.spindle(3000)
    for origin in ([100, 50, -20], [300, 50, -20], [100, 250, -25], [300, 250, -25]):
        before, p.origin = p.origin, origin
        if before[2] == 0:
            p.rapid(5, 5)
            p.rapid(z=25)
        elif origin[1] == 50:
            p.rapid(5, 5)
        else:
            p.rapid(5, 5, 25)
        p.pecks(5, 5, r=2, z=-12, q=4, out=2, clearance=0.254, f=100)
        p.rapid(z=25)
    p.spindle(0)
    p.home("z")
    p.stopped()
