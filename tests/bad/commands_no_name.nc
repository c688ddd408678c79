(expect SC1051 4:1)
f 600
l 1 0
5 0
7 0
l 0 1
