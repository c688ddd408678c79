#1=2
o1 if [#1 EQ 1]
G0 X1
o1 elseif [#1 EQ 2]
G0 X2
o1 elseif [#1 EQ 2]
G0 X3
o1 else
G0 X4
o1 endif
o2 if [#1 EQ 3]
G0 Y1
o2 else
G0 Y2
o2 endif
o3 if [0]
G0 Y3
o3 endif
M2
