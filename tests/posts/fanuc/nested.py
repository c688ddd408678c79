# SPDX-License-Identifier: MIT
"""P31131 calls O1131 three times, which calls O1132 twice; G65 with L and I J twice; a loop left by GOTO."""
OPTIONS = ["--dialect", "fanuc"]
WARNINGS = ["SC1035", "SC1036", "SC2128"]  # M98 P of five digits


def path(p):
    p.tool(2)
    p.spindle(1800)
    p.rapid(0, 0, 10)
    for y in (0, 10, 20):
        for x in (5, 10):
            p.rapid(x, y)
            p.line(z=-1, f=90)
            p.rapid(z=10)
        p.rapid(0)
        p.rapid(y=y + 10)
    p.rapid(0, 0)
    x = y = 0
    for _ in range(2):
        x, y = x + 10 + 1, y + 2
        p.rapid(x, y)
        x, y = x + 3, y + 4 - 1
        p.rapid(x, y)
    for x in (10, 11, 20):
        p.rapid(x)
    p.rapid(z=20)
    p.spindle(0)
    p.stopped()
