(expect 2 blocks, 1 mm, to 1 0 0)
N10
N20 G21 G90
N30
N40 G0 X1
N50
N60 M2
