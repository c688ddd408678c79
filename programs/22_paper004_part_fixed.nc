(SPDX-License-Identifier: MIT)
(22  THE PART OF PAPER 004, TABLE 1, AT A FIXED FEED)
(A ball of 3 mm, 12500 rpm, F7000, passes 0.2 mm apart: 0.28 mm per tooth, more than the)
(passes are apart. The paper shows its part as a picture only; this one goes 20 degrees)
(up, over a crest of 60 mm radius, and down. Program 23 is the same with G06.4.)

o100 sub             (a pass at Y#1)
  G00 X0 Y#1
  G01 Z0 F7000
  X18.7939 Z6.8404
  G03 X59.8363 I20.5212 K-56.3816
  G01 X78.6302 Z0
  G00 Z15
o100 endsub

T2 M06
S12500 M03
G00 Z15
G18
#1=0
o1 repeat [5]
  o100 call [#1]
  #1=[#1+0.2]
o1 endrepeat
M05
M30
