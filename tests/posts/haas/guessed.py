# SPDX-License-Identifier: MIT
"""Read with --dialect auto: G154, G187 and M97 say that it is Haas', so P1.5 of G04 is in seconds."""
OPTIONS = ["--dialect", "auto"]
WARNINGS = ["SC2120", "SC2384"]  # the unit of P


def path(p):
    p.tool(1)
    p.spindle(1000)
    p.rapid(10, 10)
    p.flood()
    p.rapid(z=10)
    p.line(z=-2, f=120)
    p.rapid(z=10)
    p.dwell(1.5)
    p.rapid(20)
    p.line(z=-2)
    p.rapid(z=10)
    p.dry()
    p.home("z")
    p.spindle(0)
    p.stopped()
