(expect 4 blocks, 34.142 mm, to 0 0 0)
G21 G90
G0 X10 Y10 Z-5
G91 G28 Z0
G90 G0 X0 Y0
M2
