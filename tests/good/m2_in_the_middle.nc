(expect 2 blocks, 1 mm, to 1 0 0)
G21 G90 G0 X1
M2
G0 X99
this is no program any more
