(expect SC2306 2:1)
o1 return
M30
