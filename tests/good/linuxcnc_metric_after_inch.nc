(expect 5 blocks, 159.12 mm, to 0 0 6.35)
G20 (inches first)
G0 X1 Y1 Z0.25
F20
G1 X2
G21 (and millimetres)
G1 X50.8 Y50.8 F500
G20
G1 X0 Y0 F25
G21
M2
