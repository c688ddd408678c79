(SPDX-License-Identifier: MIT)
(21  A SURFACE BY ITS ROUGHNESS: THE HILL OF PAPER 004, FIGURES 11 AND 12)
(The curve of program 11 with the roughness of the paper: 10.67 um by a ball of)
(5 mm and two teeth, passes 0.5 mm apart. Around the top, in the middle of the curve,)
(the feed sinks to 65 %, as in figure 12. D and L are those of tool 1 in the machine file.)
(Four passes: between them softcnc surface shows what is left.)

o100 sub             (a pass at Y#1)
G00 X0 Y#1
Z0
(begin curve hill F6000)
G06.2 P4 K0 X0 Z0 F6000
K0 X5 Z1
K0 X15 Z6
K0 X28 Z10
K0.2 X42 Z10
K0.4 X55 Z6
K0.6 X65 Z1
K0.8 X70 Z0
K1
K1
K1
K1
(end curve)
G00 Z15
o100 endsub

T1 M06
S6000 M03
G00 Z15
G06.4 J0.5 H10.67
#1=0
o1 repeat [4]
  o100 call [#1]
  #1=[#1+0.5]
o1 endrepeat
G06.5
M05
X0
M30
