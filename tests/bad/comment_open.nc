(expect SC1009 2:8)
G00 X1 (never closed
G00 X2
M30
