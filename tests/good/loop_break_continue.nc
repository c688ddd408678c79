(expect 4 blocks, 4 mm, to 4 0 0)
G21 G90
#1=0
o1 while [1]
#1=[#1+1]
o2 if [#1 EQ 2]
o1 continue
o2 endif
o3 if [#1 GT 4]
o1 break
o3 endif
G0 X#1
o1 endwhile
M2
