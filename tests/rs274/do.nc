#1=0
o1 do
G0 X#1
#1=[#1+1]
o1 while [#1 LT 3]
o2 do
G0 Y#1
o2 while [0]
M2
