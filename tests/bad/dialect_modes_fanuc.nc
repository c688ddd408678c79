(expect SC2120 2:5; check; fanuc)
G04 P2000
G04 P500
M30
