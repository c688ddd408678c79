# SPDX-License-Identifier: MIT
"""G43 with and without H, G43.2 adds a length, G43.1 gives one; #5403 is the length of the tool in the spindle."""
WARNINGS = ["SC2123", "SC2124"]


def path(p):
    p.tool(1)
    p.rapid(0, 0, 10 + 50)
    p.rapid(50)
    p.spindle(2000)
    p.line(z=50, f=200)
    p.spindle(0)
    p.rapid(z=60)
    p.tool(2)
    p.rapid(z=20 + 62.5)
    p.rapid(z=20 + 62.5 + 50)
    p.rapid(z=20 + 30)
    p.tool(1)
    p.rapid(1, z=50)
    p.stopped()
