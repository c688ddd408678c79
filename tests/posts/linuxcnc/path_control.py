# SPDX-License-Identifier: MIT
"""Path modes with their tolerances: the programmed path is the same in all of them."""


def path(p):
    p.rapid(z=2)
    p.line(z=-1, f=1200)
    for step in range(1, 7):
        p.line(10 * step, step * step / 10)
    p.rapid(z=2)
    p.stopped()
