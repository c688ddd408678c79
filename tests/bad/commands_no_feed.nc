(expect SC2352 2:1)
l 10 0
l 0 10
f 600
l 5 5
