# SPDX-License-Identifier: MIT
"""M73 restores the modes at the end of a call, M70 with M72 where they stand: units, distances, feed, plane."""


def path(p):
    p.rapid(10, 10)
    p.line(12.54, f=254)
    p.line(y=12.54)
    p.line(20, f=300)
    p.line(21, f=50)
    p.line(22, f=300)
    p.line(12.7, f=4 * 25.4)
    p.cw(22.7, 22.54, at=(22.7, 12.54), f=300)
    p.stopped()
