(expect 15 blocks, 208 mm, to 0 8 0)
G21 G90 F800
#1=0
o1 while [#1 LT 5]
  G0 Y[#1*2]
  G1 X20
  G0 X0
  #1=[#1+1]
o1 endwhile
M2
