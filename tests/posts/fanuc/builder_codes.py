# SPDX-License-Identifier: MIT
"""M31, M33 and M19 change no path; M88 and M89 switch coolant; M25 waits: as builder_codes.toml declares them."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(7)
    p.spindle(2000)
    p.flood()
    p.rapid(10, 10)
    p.rapid(z=10)
    p.line(z=-3, f=100)
    p.line(30, f=300)
    p.dry()
    p.dwell(1.5)
    p.line(50)
    p.rapid(z=10)
    p.spindle(0)
    p.home("z")
    p.stopped()
