# SPDX-License-Identifier: MIT
"""Power by S in the middle of a path, alone on a line and beside F; M4 (power by speed) on grbl."""
OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.rapid(5, 5)
    p.spindle(-600)
    p.line(25, f=1500)
    p.ccw(30, 10, at=(25, 10))
    p.line(y=25)
    p.spindle(-300)
    p.line(5)
    p.line(y=5)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
