(expect 3 blocks, 12 mm, to 5 7 0)
G21 G90
#1=5
G0 X#1 #1=7
G0 Y#1
M2
