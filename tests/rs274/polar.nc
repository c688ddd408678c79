(polar words in moves and arcs, absolute and relative)
G21 G17 G90 F300
G0 X5 Z2
G1 @10 ^90
@12
^-30
@-4 ^10 Z1
G20 @1 ^45
G21
G91 @1 ^30
^90
@-2
^15 Z1
G90
#1=20
G1 @[#1+2] ^[#1/3]
G3 @22 ^90 R40
G2 @22 ^0 I0 J-22
G3 ^180 R22 Z3
G92 X1 Y2
G1 @10 ^0
G92.1
G10 L2 P1 X3 Y4 R30
G1 @10 ^90
G91 ^30
M2
