(expect SC1010 2:12)
G00 (drill (5 mm) long) X1
M30
