(expect SC2103 3:1, SC2104 4:1, SC2103 5:1)
f 600
pcw 10 0 4 1
pccw 0 0 0 0
PCCW 10 0 3 0
