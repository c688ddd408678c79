(expect SC2134 4:1; check)
G92 X5
G00 X1
G92.1 X0
M30
