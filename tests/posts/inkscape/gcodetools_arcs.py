# SPDX-License-Identifier: MIT
"""A path of biarcs: -0 as a distance to the centre, a comment right after a word, M3 without S."""
WARNINGS = ["SC2203"]


def path(p):
    p.rapid(z=5)
    p.rapid(10, 20)
    p.line(z=-1, f=100)
    p.cw(15, 25, at=(15, 20), f=400)
    p.line(32)
    p.ccw(37, 30, at=(32, 30))
    p.cw(39.071068, 35, at=(44.071068, 30))
    p.rapid(z=5)
    p.rapid(0, 0)
    p.stopped()
