(SPDX-License-Identifier: MIT)
(THE FIGURE EIGHT: degree 2, seven points, weights up to 25)
(After M.-Y. Cheng, M.-C. Tsai and J.-C. Kuo, Int. J. Machine Tools and Manufacture)
(42, 2002; papers differ in its scale.)
G00 X0 Y0
(begin curve infinity F6000)
G06.2 P3 K0 X0 Y0 F6000
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
