(expect 6 blocks, 33.133 mm, to 0 0 0)
(a chain of arcs without repeating the code)
G21 G90 G17 F800
G0 X0 Y0
G3 X4 Y4 R4
X8 Y8 R4
X12 Y4 R4
X8 Y0 R4
G1 X0 Y0
M2
