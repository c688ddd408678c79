# SPDX-License-Identifier: MIT
"""A cut with M4: S and F beside the first line, no blanks between words, S0 at the end, air by M8."""
OPTIONS = ["--dialect", "grbl"]
WARNINGS = ["SC2203"]


def path(p):
    p.flood()
    p.rapid(10, 10)
    p.spindle(-800)
    p.line(50, f=1200)
    p.line(y=40)
    p.line(10)
    p.line(y=10)
    p.dry()
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
