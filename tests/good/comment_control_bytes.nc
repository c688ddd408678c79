(expect 2 blocks, 1 mm, to 1 0 0)
(tab	here, escape [31m, bell , delete )
G21 G90 G0 X1
M2
