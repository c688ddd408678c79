(SPDX-License-Identifier: MIT)
(29  THE CENTRE OF A POCKET)
(A probe goes to both sides along X and along Y. The middle of two contacts is the centre, whatever)
(the radius of the ball is. Controls with G31 run the same with that code.)
(docs/probing.md)
G21 G90 G17 G49 G94 G54
G00 X75. Y40.
Z-20.
G38.2 X40. F500.
#101=#5061
G01 X75.
G38.2 X115. F500.
#102=#5061
#103=[[#101+#102]/2.]
G01 X#103
G38.2 Y20. F500.
#104=#5062
G01 Y40.
G38.2 Y70. F500.
#105=#5062
#106=[[#104+#105]/2.]
G01 Y#106
G10 L2 P1 X#103 Y#106
G00 Z10.
M30
