(expect 1 blocks, 0 mm, to 0 0 0)
M30
