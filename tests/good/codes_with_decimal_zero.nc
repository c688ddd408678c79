(expect 5 blocks, 2 mm, to 0 0 0)
G21.0 G90.0
G1.0 X1 F60
G0.0 X0
M3.0 S10
M5.0
M2.0
