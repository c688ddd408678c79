(The first part of docs/operate.md: a step around a block, then a groove across it.)
(Work zero: the front left corner of the block, at its upper side.)
G21 G90 G94 G17 G64 P0.02
(the step, with the end mill)
T1 M06
G43 H1
S8000 M03
M08
G00 X-8 Y1
Z5
Z-2
G01 X59 F1200
Y39
X1
Y-8
G00 Z5
M09
M05
(the groove, with the ball nose)
T2 M06
G43 H2
S10000 M03
M08
G00 X10 Y20
Z5
G01 Z-1.5 F300
G02 X30 Y20 I10 J0 F900
G03 X50 Y20 I10 J0
G00 Z5
M09
M05
G00 X0 Y0
M30
