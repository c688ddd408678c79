(expect SC2310 3:1; limit 1000)
N7 G0 X1
GOTO 7
M30
