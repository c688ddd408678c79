(expect 3 blocks, 3 mm, to 1 2 0)

G21 G90
G00 X1

Y2
M30
