(expect 5 blocks, 5.064 mm, to 3 4 0)
g21 G90
G0 x1 Y2
g1 X3 y4 f100
M3 s100
m5
m30
