# SPDX-License-Identifier: MIT
"""Lines of the sender (homing, status) are no moves; grbl begins with G0 in force, so coordinates alone are rapids."""
OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.rapid(10, 10)
    p.rapid(20)
    p.spindle(-500)
    p.line(y=20, f=1000)
    p.line(10)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
