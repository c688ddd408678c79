# SPDX-License-Identifier: MIT
"""A named subprogram with arguments, its own names and a value that it returns: 6 and 8 holes, 14 in all."""
from path import polar


def path(p):
    p.tool(1)
    p.spindle(1500)
    p.rapid(z=10)
    for radius, first, count, depth in ((30, 0, 6, 12), (15, 22.5, 8, 4)):
        for hole in range(count):
            p.rapid(*polar(radius, first + hole * 360 / count, (50, 40)))
            p.rapid(z=1)
            p.line(z=-depth, f=120)
            p.rapid(z=10)
    p.rapid(14, 0)
    p.spindle(0)
    p.stopped()
