(expect SC2133 2:1; check)
G61
G00 X5
M30
