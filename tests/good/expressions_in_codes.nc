(expect 4 blocks, 1 mm, to 1 0 0)
G[10+11] G90
M[2+1] S[500*2]
G[0] X[1] F[100+1]
M5
M2
