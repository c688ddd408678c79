# SPDX-License-Identifier: MIT
"""A bore by helices: in half turns of 0.5 mm, then in one block of three turns (P) and a full circle."""


def path(p):
    p.tool(1)
    p.spindle(6000)
    p.rapid(z=10)
    p.rapid(25, 30)
    p.rapid(z=1)
    p.line(z=0, f=150)
    for half in range(1, 7):
        p.cw(x=15 if half % 2 else 25, z=max(-0.5 * half, -2), at=(20, 30), f=350)
    p.rapid(z=10)
    p.rapid(x=28)
    p.rapid(z=1)
    p.cw(z=-2, at=(20, 30), turns=2)
    p.cw(at=(20, 30))
    p.rapid(z=10)
    p.spindle(0)
    p.stopped()
