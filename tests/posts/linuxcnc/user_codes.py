# SPDX-License-Identifier: MIT
"""M64, M65 at once, M62, M63 with the next move, M67, M68 the same of a value; M102 stops.

M66 reads inputs at once (L0), and waits in vain for one that stays off: #5399 is then -1.
"""


def path(p):
    p.spindle(3000)
    p.output("vacuum", 1)
    p.line(10, f=300)
    p.output("vacuum", 0)
    p.output("air", 1)
    p.line(20)
    p.output("laser", 0.75)
    p.line(30)
    p.output("laser", 0)
    p.output("air", 0)
    p.line(40)
    p.line(y=10)
    p.dwell(2)
    p.line(y=20)
    p.line(41.25)
    p.stop()
    p.spindle(0)
    p.stopped()
