(expect SC3116 2:1; fanuc)
G5.1 Q1 X5
M30
