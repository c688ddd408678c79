(expect 4 blocks, 22.05 mm, to 1 0 20)
G21 G90
G43.1 Z10
G0 X1 Z0
G1 Z-1 F100
G49
G0 Z20
M2
