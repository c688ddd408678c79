(expect 8 blocks, 295.69 mm, to -3 -3 2)
(plate with margins as variables)
G21 G90
#1=80 (length)
#2=50 (width)
#3=3 (tool radius)
#4=-1.5 (depth)
F600
G0 X[0-#3] Y[0-#3] Z2
G1 Z#4
X[#1+#3]
Y[#2+#3]
X-#3
Y-#3
G0 Z2
M2
