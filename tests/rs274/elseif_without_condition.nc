F100
o1 if [1]
G1 X1
o1 elseif
G1 X2
o1 endif
M2
