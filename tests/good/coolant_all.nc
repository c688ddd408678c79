(expect 6 blocks, 0 mm, to 0 0 0)
M7
M8
M9
M7
M9
M2
