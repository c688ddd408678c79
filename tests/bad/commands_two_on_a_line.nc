(expect SC1053 4:8)
f 600
l 1 1
l 10 0 l 0 10
l 1 1
