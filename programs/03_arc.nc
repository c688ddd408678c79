(SPDX-License-Identifier: MIT)
(03  ARCS)
(G02 turns clockwise, G03 counter-clockwise, seen from above the X Y plane.)
(X and Y are the end. I and J are the distance from the start to the centre along X)
(and Y: always distances, even where coordinates are positions.)

G00 X40 Y40
N10 G02 X60 Y20 I0 J-20 F1200    (a quarter of radius 20 about X40 Y20)

(A line that leaves an arc in its direction is passed without a stop.)
N20 G01 X60 Y0 F3000

(End and start may be the same point: that is one full circle.)
N30 G03 X60 Y0 I-15 J0

(With R the centre need not be known. Two arcs of this radius lead from one point)
(to the other: a positive R asks for the short one, a negative R for the long one.)
N40 G00 X0 Y0
N50 G02 X20 Y20 R20              (the shorter arc: a quarter)
N60 G03 X0 Y0 R-20               (the longer arc back: three quarters)

(An arc needs acceleration even at constant speed: v2 / r towards its centre. At)
(F3000, 50 mm/s, on r = 20 mm that is 125 mm/s2, and the feed binds. At F15000 it)
(would be 3125 mm/s2, more than the axes have: softcnc then slows down by itself.)
M30
