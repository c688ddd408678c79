(expect SC3120 6:3)
F600 G00 X0
G05.2 P1
#1=0
o1 repeat [10001]
  X#1 Y[#1 MOD 2] P1
  #1=[#1+1]
o1 endrepeat
G05.3
M30
