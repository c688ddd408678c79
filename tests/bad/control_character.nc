(expect SC1001 2:7)
G00 X1
M30
