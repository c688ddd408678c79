(expect 5 blocks, 6.742 mm, to 4 2 3)
g21 g17
t1 m6 s500 m3
g0 x1 y2 z3
g1 x4 f100
m30
