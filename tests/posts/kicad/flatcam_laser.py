# SPDX-License-Identifier: MIT
"""A laser on grbl: M03 and M05 around every path, no Z, no end of the program."""
OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.rapid(1, 1)
    p.spindle(400)
    for x, y in ((21, 1), (21, 6), (1, 6), (1, 1)):
        p.line(x, y, f=800)
    p.spindle(0)
    p.rapid(4, 3)
    p.spindle(250)
    p.line(18)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
