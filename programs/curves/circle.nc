(SPDX-License-Identifier: MIT)
(THE CIRCLE AS A NURBS: degree 2, nine points, radius 10 mm)
(L. Piegl and W. Tiller, The NURBS Book, chapter 7. Its double knots are jumps)
(of the derivative by the parameter; the curve itself is a circle, so what runs)
(evenly along its length shows none of it.)
G00 X10 Y0
(begin curve circle F3000)
G06.2 P3 K0 X10 Y0 F3000
K0 X10 Y10 R0.7071067811865476
K0 X0 Y10
K0.25 X-10 Y10 R0.7071067811865476
K0.25 X-10 Y0
K0.5 X-10 Y-10 R0.7071067811865476
K0.5 X0 Y-10
K0.75 X10 Y-10 R0.7071067811865476
K0.75 X10 Y0
K1
K1
K1
(end curve)
M30
