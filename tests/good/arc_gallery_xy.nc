(expect 10 blocks, 135.664 mm, to 10 0 0)
(all quarters, both ways, from a common point)
G21 G90 G17 F1000
G0 X10 Y0
G3 X0 Y10 I-10 J0
G3 X-10 Y0 I0 J-10
G3 X0 Y-10 I10 J0
G3 X10 Y0 I0 J10
G2 X0 Y-10 I-10 J0
G2 X-10 Y0 I0 J10
G2 X0 Y10 I10 J0
G2 X10 Y0 I0 J-10
M2
