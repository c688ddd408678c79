(expect 10 blocks, 52.071 mm, to 0 0 5)
(what acts first does not depend on where it stands)
X10 F600 G1 G21 G90
M5 X20 (the spindle stops before the move)
Y5 S500 M3
G4 P.25
G0 X0
Z5 G0 Y0
M2 M9
