(SPDX-License-Identifier: MIT)
(20  A SURFACE BY ITS ROUGHNESS: THE CYLINDER OF PAPER 004, FIGURE 8)
(A ball end mill climbs over a cylinder and down again, pass beside pass. Where the path)
(is level its tip cuts, and the tip turns too slowly: it leaves twice the height of the)
(rest. G06.4 says what may be left, and the feed sinks there to 65 %, and nowhere else.)

(D5 J0.5 H10.67 L2: a ball of 5 mm, passes 0.5 mm apart, Rmax 10.67 um, two teeth. At)
(6000 rpm they cut 0.5 mm each at F6000, which leaves 10.67 um where the path is steep.)
(The machine file beside this one keeps the roughness by the formulas of the paper.)
(Remove it, and edges simulated on the ball keep it: that costs a little more time, and)
(the target is also kept where the tip begins to cut. softcnc check shows both.)

o100 sub             (a pass at Y#1: 25 degrees up, over the top, 25 degrees down)
  G00 X-21.1309 Y#1
  G01 Z45.3154 F6000
  G03 X21.1309 I21.1309 K-45.3154
  G00 Z60
o100 endsub

S6000 M03
G00 Z60
G18
G06.4 D5 J0.5 H10.67 L2
#1=0
o1 repeat [4]
  o100 call [#1]
  #1=[#1+0.5]
o1 endrepeat
G06.5
M05
M30
