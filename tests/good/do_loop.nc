(expect 5 blocks, 4 mm, to 4 0 0)
G21 G90
#1=0
o3 do
#1=[#1+1]
G0 X#1
o3 while [#1 LT 4]
M2
