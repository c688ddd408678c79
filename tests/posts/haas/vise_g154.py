# SPDX-License-Identifier: MIT
"""The same slot in G154 P1 and P20, whose origins the program sets by G10 L20, in inches."""
OPTIONS = ["--dialect", "haas"]
WARNINGS = ["SC2269"]  # G10 L20


def path(p):
    p.unit = 25.4
    p.tool(1)
    p.origin = [-254, -127, -203.2]
    p.spindle(4500)
    p.rapid(-0.5, 0)
    p.flood()
    p.rapid(z=1)
    p.line(z=-0.25, f=20)
    p.line(3, f=45)
    p.rapid(z=1)
    p.origin = [-16 * 25.4, -127, -203.2]
    p.rapid(-0.5, 0)
    p.line(z=-0.25, f=20)
    p.line(3, f=45)
    p.rapid(z=1)
    p.dry()
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
