(expect SC2302 2:1)
o1 if [0]
G0 X1
M30
