(expect SC1012 2:1, SC1012 3:8)
%(the program) G21
G00 X1 %
G00 X2
M30
