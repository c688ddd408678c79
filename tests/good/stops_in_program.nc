(expect 5 blocks, 3 mm, to 3 0 0)
G21 G90
G0 X1
M0
G0 X2
M1
G0 X3
M2
