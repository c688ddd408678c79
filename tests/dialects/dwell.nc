(expect 7 blocks, 2 mm, to 2 0 0)
G04 P0.5
G04 P0
G4 P1.25
P2 G04
G01 X1 F100
G04 P1 X2
M30
