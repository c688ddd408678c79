(expect 5 blocks, 2 mm, to 2 0 0)
G21 G90
G0 X1
G80
M8
G80
G1 X2 F100
G80
M9
M2
