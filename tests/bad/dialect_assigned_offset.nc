(expect SC1039 3:5; check)
#5221=10
G00 X5
M30
