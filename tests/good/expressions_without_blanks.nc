(expect 3 blocks, 13.893 mm, to -1 2 0)
g21g90f600
#1=1#2=2
g1x[#1+#2]y[#1-#2*3]
x-#1y+#2
m2
