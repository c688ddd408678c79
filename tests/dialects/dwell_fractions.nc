(expect 4 blocks, 0 mm, to 0 0 0)
G4 P0
G4 P.001
G04 P1.5
G4 P0.25
M2
