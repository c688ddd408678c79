# SPDX-License-Identifier: MIT
"""A line of an image there, another one back: a new power with each modal line."""
OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.rapid(1, 1)
    for pixel, power in enumerate((0, 64, 128, 192, 255, 192, 128, 64), 1):
        p.spindle(power)
        p.line(1 + 0.25 * pixel, f=3000)
    p.spindle(0)
    p.rapid(y=1.25)
    for pixel, power in enumerate((64, 128, 0), 1):
        p.spindle(power)
        p.line(3 - 0.25 * pixel)
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
