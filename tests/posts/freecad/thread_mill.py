# SPDX-License-Identifier: MIT
"""A thread M12x1.75 milled upwards: half circles in and out, half turns of half the pitch, spindle counter-clockwise."""
PITCH = 1.75


def path(p):
    p.tool(11)
    p.spindle(-2500)
    p.rapid(z=8)
    p.rapid(40, 40)
    p.rapid(z=2)
    p.line(z=-9.75, f=300)
    z = -9.75 + PITCH / 4
    p.ccw(40, 42.2, z, at=(40, 41.1), f=80)
    for half in range(4):
        z += PITCH / 2
        p.ccw(40, 37.8 if half % 2 == 0 else 42.2, z, at=(40, 40))
    p.ccw(40, 40, z + PITCH / 4, at=(40, 41.1))
    p.rapid(z=8)
    p.spindle(0)
    p.stopped()
