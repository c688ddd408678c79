(expect 6 blocks, 46.204 mm, to 0 -5 0)
G21 G90 F600
G1 X[1+2*3] Y[[1+2]*3]
X[2**3*2] Y[10/4/5]
X[5 GT 3] Y[5 LT 3]
X[1 AND 0] Y[1 OR 0]
X[1 XOR 1] Y[3 EQ 3]
X[3 NE 3] Y[-[2+3]]
M2
