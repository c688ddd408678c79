(expect SC2304 2:4)
N5 o1 else
M30
