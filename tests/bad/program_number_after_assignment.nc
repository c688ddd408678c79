(expect SC2006 2:6)
#1=-4o.963
G00 X#1
M30
