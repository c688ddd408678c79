# SPDX-License-Identifier: MIT
"""repeat, do with continue, while with break, and a factorial that calls itself; ATAN, MOD and the roundings."""
WARNINGS = ["SC1032", "SC1033"]  # MOD, ROUND


def path(p):
    for x in (2, 4, 6):
        p.line(x, f=600)
    for y in (5, 15, 40, 25):
        p.line(y=y)
    for x in (7, 4, 1):
        p.line(x)
    p.rapid(24, 45)
    p.rapid(2 + 3 + 3, z=2)  # -8 MOD 5 is 2
    p.stopped()
