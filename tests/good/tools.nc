(expect 5 blocks, 0 mm, to 0 0 0)
T1 M06
T2
M06
M06 T3
T00 M6
M30
