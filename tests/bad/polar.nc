(expect SC1001 2:5)
G00 @5 ^30
M30
