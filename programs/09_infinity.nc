(SPDX-License-Identifier: MIT)
(09  THE FIGURE EIGHT)
(Seven points of degree 2, so P3, with weights up to 25: heavy points draw the)
(curve so near that it turns sharply beside them, and runs almost straight between.)
(After Cheng, Tsai and Kuo, Int. J. Machine Tools and Manufacture 42, 2002.)

(The knot 0.5 occurs twice, which for degree 2 permits a corner. Here the points on)
(both sides are in line with the crossing, so there is none, and the curve runs)
(through X0 Y0 without a stop. Only its curvature may jump there.)
(F12000 is more than the sharp turns allow: on 5.6 mm and 1000 mm/s2 about 75 mm/s.)

(begin curve infinity F12000)
G06.2 P3 K0 X0 Y0 F12000
K0 X-150 Y-150 R25
K0 X-150 Y150 R25
K0.25 X0 Y0
K0.5 X150 Y-150 R25
K0.5 X150 Y150 R25
K0.75 X0 Y0
K1
K1
K1
(end curve)
M30
