(expect 3 blocks, 7 mm, to 3 4 0)
G21 G90 G0 X3
G1 Y4 F50
M2 ; the end