(expect SC2172 5:1; fanuc)
O0027 (a subprogram, read by itself)
G90 G01 X10. F100
X0
M99
