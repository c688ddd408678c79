(expect SC3120 6:3)
F600
G06.1
#1=0
o1 repeat [10001]
  X[#1+1]
  #1=[#1+1]
o1 endrepeat
G80
M30
