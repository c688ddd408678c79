(expect SC2303 2:1)
o1 sub
G0 X1
M30
