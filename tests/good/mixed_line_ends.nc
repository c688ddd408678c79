(expect 5 blocks, 4 mm, to 4 0 0)
G21 G90
G0 X1
G0 X2G0 X3

G0 X4
M2