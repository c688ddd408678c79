(expect 3 blocks, 50.8 mm, to 0 0 0)
G21 G90 F300
M70
G20 G91
G1 X1
M72
G1 X0
M2
