(expect 1 blocks, 0 mm, to 0 0 0)
O5
N1 G21
M30
