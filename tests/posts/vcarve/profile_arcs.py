# SPDX-License-Identifier: MIT
"""A contour as for Mach: no blanks between words, numbers of lines, a % at the end alone, M06 after its T."""


def path(p):
    p.tool(1)
    p.rapid(z=20)
    p.spindle(16000)
    p.rapid(17, 20, 5)
    p.line(z=-3, f=500)
    p.line(y=40, f=1500)
    p.cw(37, 60, at=(37, 40))
    p.line(x=80)
    p.cw(97, 43, at=(80, 43))
    p.ccw(110, 30, at=(110, 43))
    p.rapid(z=5)
    p.rapid(z=20)
    p.rapid(0, 0)
    p.stopped()
