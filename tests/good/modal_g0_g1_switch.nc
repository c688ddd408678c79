(expect 8 blocks, 12 mm, to 0 0 0)
G21 G90 F500
G0 X1
X2
G1 X3
X4
G0
X5
G1
X6
G80
G0 X0
M2
