(expect 7 blocks, 6 mm, to 0 0 0)
G21 G90 F600
G1 X1
Y1
Z1
X0
Y0
Z0
M2
