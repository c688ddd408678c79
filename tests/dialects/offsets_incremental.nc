(expect 4 blocks, 7.414 mm, to 5 5 0)
G21 G91
G10 L2 P1 X5 Y5
G0 X1 Y1
G0 X1
G90 G0 X0 Y0
M2
