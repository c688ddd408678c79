(expect 2 blocks, 4 mm, to 4 0 0)
G21 G90
G0 X[#31+4] Y#32
M2
