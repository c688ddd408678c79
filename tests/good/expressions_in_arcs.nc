(expect 5 blocks, 57.124 mm, to 0 -10 0)
G21 G90 F600
#5=10
G0 X#5 Y0
G3 X0 Y#5 I[-#5] J0
G3 X[-#5] Y0 R#5
G3 X0 Y[0-#5] R[SQRT[100]]
M2
