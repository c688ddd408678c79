(SPDX-License-Identifier: MIT)
(25  ROTATION, SCALING, MIRROR, POLAR COORDINATES)
(One figure, programmed once, is cut turned, larger, stretched and mirrored; then holes)
(lie on a circle. What is in force moves the figure: mirror first, then scales, then the turn.)

G17 G21 G90 G94
M03 S6000
F900

G68 X0 Y0 R-20.      (turned by 20 degrees clockwise about the zero point)
o100 call
G69

G51 X30 Y0 Z0 P1.5   (half as large again, from X30 Y0 on; P1500 is the same)
o100 call
G50

G51 X0 Y30 Z0 I.5 J2. K1.   (stretched along Y: its arcs are ellipses, which run as NURBS)
o100 call
G50

G51.1 X-5            (mirrored at X-5: the arcs go the other way round)
o100 call
G50.1

G52 X-40 Y-40        (the holes lie around this point)
G16                  (X is a radius, Y an angle)
G99 G81 X15 Y0 Z-3 R1 F300
G91 Y60. Z-4 R-4 L5  (five more, 60 degrees apart: R from Z5, Z from R)
G80 G90 G15
G52 X0 Y0

G00 Z5
M05
G00 X0 Y0
M30

o100 sub             (the figure: a slot with round ends and a bulge)
  G00 X5 Y5 Z5
  G01 Z-1 F300
  X25 F900
  G03 X25 Y15 R5
  G01 X20
  G02 X10 I-5 J0
  G01 X5
  G03 X5 Y5 I0 J-5
  G00 Z5
o100 endsub
