(expect SC2008 3:1, SC2008 5:1, SC2008 6:1; axes XZ)
f 600
l 0 1
l 1 0 5
pcw 10 0 5 0
s 1 5 5
