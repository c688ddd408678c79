# SPDX-License-Identifier: MIT
"""The plainest contour: modal words, arcs by centre and by radius, home in Z and then in X Y within G91."""
OPTIONS = ["--dialect", "fanuc"]


def path(p):
    p.tool(1)
    p.spindle(3500)
    p.rapid(-15, -10)
    p.rapid(z=50)
    p.rapid(z=5)
    p.line(z=-6, f=200)
    p.line(y=0, f=800)
    p.cw(-5, 10, at=(-5, 0))
    p.line(x=45)
    p.cw(55, 0, at=(45, 0))
    p.line(y=-30)
    p.ccw(65, -40, at=(65, -30))
    p.line(x=70)
    p.line(z=4)
    p.rapid(z=50)
    p.spindle(0)
    p.home("z")
    p.home("xy")
    p.stopped()
