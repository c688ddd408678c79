(expect 6 blocks, 3 mm, to 3 0 0)
G00 X1
M00
G00 X2
M01
G00 X3
M00 (turn the part over)
M02
