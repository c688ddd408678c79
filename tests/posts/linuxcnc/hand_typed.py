# SPDX-License-Identifier: MIT
"""Lower case, tabs, blanks within words, a numbered subprogram, overrides off and on, a stop by M60."""
WARNINGS = ["SC2120"]  # P of a dwell


def path(p):
    p.tool(1)
    p.spindle(1200)
    p.rapid(10, 10, 5)
    p.line(z=-0.5, f=250)
    p.line(14, 12)
    p.line(14.5, 12.25)
    p.line(10)
    p.stop()
    p.dwell(0.25)
    p.rapid(z=5)
    p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
