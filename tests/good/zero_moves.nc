(expect 3 blocks, 10 mm, to 0 0 0)
G21 G90 F100
G1 X0 Y0
G0 X0
G1 X5
G1 X5
X5 Y0 Z0
G0 X0
X0
M2
