(expect 4 blocks, 40 mm, to 0 0 0)
G21 G90
G93 G1 X10 F2
X20 F4
G94
X0 F600
M2
