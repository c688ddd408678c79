(expect 5 blocks, 6.883 mm, to 3 2 3)
g21g90f300
g1x1y2z3
g2x3y2i1j0
m3s100
m5
m2
