(expect 2 blocks, 2 mm, to 2 0 0)
G21 G90 F200
#1=3
o1 if [#1 GT 5]
G0 X1
o1 elseif [#1 EQ 3]
G0 X2
o1 else
G0 X3
o1 endif
M2
