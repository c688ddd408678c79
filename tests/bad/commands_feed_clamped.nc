(expect SC2201 2:3)
f 20000
l 10 0
f 30000
l 0 10
