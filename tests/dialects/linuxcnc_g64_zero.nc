(expect 9 blocks, 58.071 mm, to 0 0 1)
(corner by corner, exactly)
G21 G90
G61
G0 X0 Y0 Z1
F900
G1 X10
G1 Y10
G64
G1 X0
G1 Y0
G61.1
G1 X5
G1 Y5
G64
G0 X0 Y0
M2
