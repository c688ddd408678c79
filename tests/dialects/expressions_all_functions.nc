(expect 9 blocks, 237.714 mm, to 2 1 0)
G21 G90 F600
G1 X[ABS[-3]] Y[SQRT[16]]
X[COS[60]*10] Y[SIN[30]*10]
X[TAN[45]*7] Y[ATAN[1]/[1]]
X[ACOS[0.5]] Y[ASIN[0.5]]
X[EXP[1]] Y[LN[20]]
X[ROUND[2.6]] Y[FIX[-2.4]]
X[FUP[2.4]] Y[2**5]
X[10 MOD 4] Y[7-2*3]
M2
