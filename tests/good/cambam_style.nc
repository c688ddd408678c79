(expect 13 blocks, 105.121 mm, to -1.5 -1.5 3)
( Made by hand in the manner of a hobby CAM )
( Untitled )
( T0 : 0.0 )
G21 G90 G64 G40
G0 Z3.0
( T0 : 0.0 )
T0 M6
( Profile1 )
G17
M3 S1000
G0 X-1.5 Y-1.5
G0 Z1.0
G1 F300.0 Z-1.0
G1 F800.0 Y21.5
X21.5
Y-1.5
X-1.5
G0 Z3.0
M5
M30
