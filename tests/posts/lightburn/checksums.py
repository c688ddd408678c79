# SPDX-License-Identifier: MIT
"""Every line ends with a checksum of its characters, as senders add them."""
OPTIONS = ["--dialect", "grbl"]


def path(p):
    p.rapid(10, 5)
    p.spindle(1000)
    p.line(30, f=600)
    p.ccw(30, 15, at=(30, 10))
    p.spindle(0)
    p.rapid(0, 0)
    p.stopped()
