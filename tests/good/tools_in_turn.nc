(expect 5 blocks, 0 mm, to 0 0 0)
T1 M6
T2
M6
T3 M6 (c)
M6 T99
M2
