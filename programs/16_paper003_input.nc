(SPDX-License-Identifier: MIT)
(16  THE INPUT OF PAPER 003)
(Yang and Hong did not write G-code. Table 6 of their paper lists what their mill was)
(fed with: l for lines, pcw and pccw for arcs by points, dcw and dcaw for arcs by)
(degrees, s for splines, all in relative coordinates. See docs/commands.md.)
(The numbers of their workpieces are not printed; these are the shapes of program 13.)

f 3000                      ; mm/min; the table itself has no feed

(Lines.)
l 20 0
l 0 10
l -20 -10

(Arcs: half a circle in each direction, an S. First by points, with the centre seen from the)
(start; then back to where it began, by the angles of both ends and the radius.)
l 30 0
pccw 0 12 0 6
pcw 0 12 0 6
dcaw -90 90 6
dcw 270 90 6

(A spline through points, each seen from the one before.)
s 5   10 16   20 -40   15 35
      15 -15  -10 -10
