(expect SC2302 2:1)
o1 while [1]
G0 X1
M30
