(expect SC2005 2:1, SC2308 3:1; fanuc)
M97
M97 P9
M30
