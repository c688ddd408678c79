# SPDX-License-Identifier: MIT
"""WH, EN, TH and GO; the argument E after a digit is #8, no exponent."""
OPTIONS = ["--dialect", "fanuc"]
NO_EFFECT = ["line 22: X0"]  # jumped over


def path(p):
    p.tool(5)
    p.spindle(800)
    p.rapid(z=30)
    for hole in (1, 2, 3):
        p.rapid(41 + 10 * hole, 0)
        p.rapid(z=1)
        p.line(z=-hole, f=120)
        p.rapid(z=5)
    p.rapid(y=7.5)
    p.spindle(0)
    p.home("z")
    p.stopped()
