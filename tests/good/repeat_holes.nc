(expect 21 blocks, 158 mm, to 0 0 2)
G21 G90 F200
G0 Z2
o2 repeat [6]
G91 G0 X8
G90 G1 Z-3
G0 Z2
o2 endrepeat
G0 X0
M2
