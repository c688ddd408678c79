(expect SC1034 2:4; check)
#1=[1 OR 1 + 1]
M30
