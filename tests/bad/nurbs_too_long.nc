(expect SC3120 6:7)
F600 G00 X0
G06.2 P2 K0 X0
#1=0
o1 repeat [10001]
  K#1 X[#1+1]
  #1=[#1+1]
o1 endrepeat
K10000
K10000
M30
