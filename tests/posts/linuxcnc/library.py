# SPDX-License-Identifier: MIT
"""o<slot> is found in another folder (--subprograms); #<_depth> comes from the command line."""
OPTIONS = ["--subprograms", "subprograms", "--define", "_depth=2.5"]
NO_EFFECT = ["line 9: X-99"]  # of a subprogram that another file comes before


def path(p):
    p.spindle(2000)
    p.rapid(10, 10, 5)
    p.line(z=-1, f=100)
    p.line(30, f=400)
    p.rapid(z=5)
    p.rapid(10, 30)
    p.line(z=-2.5, f=100)
    p.line(10, 40, f=400)
    p.rapid(z=5)
    p.rapid(0, 0)
    p.spindle(0)
    p.stopped()
