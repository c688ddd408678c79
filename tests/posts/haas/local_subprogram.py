# SPDX-License-Identifier: MIT
"""M97 calls the lines from N on in the same program: a cross twice, and steps four times by L4."""
OPTIONS = ["--dialect", "haas"]


def path(p):
    p.tool(4)
    p.spindle(5000)
    p.rapid(10, 10)
    p.rapid(z=5)
    for x in (10, 50):
        p.rapid(x, 10)
        p.line(z=-1, f=150)
        p.line(x + 8, f=350)
        p.line(x)
        p.line(y=18)
        p.line(y=10)
        p.rapid(z=5)
    p.rapid(10, 50)
    p.line(z=0, f=200)
    for step in range(1, 5):
        p.line(10 + 5 * step, z=-0.5 * step)
        p.line(y=50 + 5 * step)
    p.rapid(z=5)
    p.spindle(0)
    p.home("z")
    p.stopped()
