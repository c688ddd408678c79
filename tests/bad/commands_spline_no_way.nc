(expect SC2350 4:1)
f 600
l 1 0
s 1 0 0
