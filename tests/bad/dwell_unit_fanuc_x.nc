(expect SC2210 2:5; fanuc)
G04 X500
G04 X0.5
M30
