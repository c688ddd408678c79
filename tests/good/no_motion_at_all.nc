(expect 1 blocks, 0 mm, to 0 0 0)
(only modes)
G21 G17 G90 G94
F100 S200
T1
M2
