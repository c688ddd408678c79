(expect 5 blocks, 43.503 mm, to 0 0 0)
G20 G90 F10
G0 X.5 Y.5
G2 X.55 Y.55 I.05 J0
G3 X.6 Y.6 R.05
G1 X0 Y0
M2
