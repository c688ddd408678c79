(expect SC1050 4:1, SC1050 6:1)
f 600
l 1 1
line 10 0
l 0 5
G01 X5
