(expect 5 blocks, 66.801 mm, to 5 5 -1)
G21 G90 F500
G0 X5 Y5
G2 I5
G3 J-2.5
G2 Z-1 I2
M2
