(expect SC2304 6:1)
o1 if [1 EQ 0]
G0 X0
o1 else
G0 X1
o1 else
G0 X2
o1 endif
M30
