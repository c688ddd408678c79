# SPDX-License-Identifier: MIT
"""Zero points by G10 L20 at the position, G55, a tool length by G43.1, inverse time, G92, G28.1, G28 and G30.

G55 is at (20, 10, 0) in machine coordinates, since its zero was set there; G54 stays at the machine's zero.
"""
OPTIONS = ["--dialect", "grbl"]
WARNINGS = ["SC2269", "SC2120", "SC2134"]  # P of a dwell; G92.1


def path(p):
    p.rapid(20, 10)
    p.origin = [20, 10, 0]
    p.rapid(5, 5, 3)
    p.origin = [20, 10, 1.5]
    p.rapid(z=3)
    p.spindle(8000)
    p.dwell(0.5)
    p.line(z=0, f=150)
    p.line(15, f=4 * 10)
    p.cw(20, 10, at=(20, 5), f=400)
    p.origin = [20, 10, 0]
    p.rapid(z=5)
    p.rapid(20 + 1, 10 + 1)
    p.spindle(0)
    p.stop()
    p.origin = [0, 0, 0]
    p.rapid(0, 0, 0)
    p.rapid(41, 21, 5)
    p.rapid(z=6)
    p.home("z")
    p.stopped()
