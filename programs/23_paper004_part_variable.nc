(SPDX-License-Identifier: MIT)
(23  THE PART OF PAPER 004, TABLE 1, AT A VARIABLE FEED)
(Program 22 with G06.4. The paper asks for 3.3 um, which passes and teeth leave where both)
(are 0.2 mm. Its equation 5 would then keep 5796 mm/min everywhere, and yet its figure 17)
(shows 7000 but where the tip cuts. Asked for what F7000 leaves beside the tip, 4.24 um,)
(the feed is that of figure 17, and the paper has measured 4.1 um. Try H3.33, too:)
(docs/roughness.md compares both. The machine file beside this one keeps the roughness by)
(the formulas of the paper, which promise too little near the critical inclination: half)
(of the regions that softcnc surface judges miss the H. Without that file none does.)

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
G06.4 J0.2 H4.24
#1=0
o1 repeat [5]
  o100 call [#1]
  #1=[#1+0.2]
o1 endrepeat
M05
M30
