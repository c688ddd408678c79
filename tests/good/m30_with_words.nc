(expect 3 blocks, 2 mm, to 2 0 0)
G21 G90 G0 X1
G1 X2 F100 M30
G0 X3
