(expect SC2205 2:0)
G00 X1
