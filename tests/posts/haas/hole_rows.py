# SPDX-License-Identifier: MIT
"""L repeats a hole in G91, row by row, R counted from the start and Z from R; then pecks by G73 from R on.

After the rows G98 goes out to the height where the cycle G73 began, which is R of the rows.
"""
OPTIONS = ["--dialect", "haas"]


def path(p):
    p.tool(8)
    p.spindle(2800)
    p.rapid(10, 10)
    p.flood()
    p.rapid(z=12)
    p.drill(10, 10, r=2, z=-7, out=2, f=140)
    p.rapid(z=12)
    for hole in range(1, 5):
        p.drill(10 + 12 * hole, 10, r=2, z=-7, out=2)
    p.rapid(z=12)
    p.rapid(70, 22)
    for hole in range(1, 6):
        p.drill(70 - 12 * hole, 22, r=2, z=-7, out=2)
    p.pecks(10, 50, r=2, z=-9, q=4, out=2, clearance=0.254, f=140, chip=True)
    p.pecks(30, 50, r=2, z=-5, q=4, out=2, clearance=0.254, chip=True)
    p.dry()
    p.home("z")
    p.spindle(0)
    p.stopped()
