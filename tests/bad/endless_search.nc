(expect SC2302 2:1, SC2302 3:1; limit 4)
o1 if [0]
o2 if [0]
G0 X1
M30
