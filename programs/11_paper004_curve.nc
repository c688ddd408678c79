(SPDX-License-Identifier: MIT)
(11  UP AND DOWN A HILL: THE SETTINGS OF PAPER 004)
(Choi, Lee, Jung and Yang cut a curved surface with a ball end mill, line by line,)
(each line a cubic NURBS in the X Z plane: upward milling first, downward milling)
(after the top. The file 11_paper004_curve.toml beside this one is their machine,)
(which interpolates every 4 ms. The knot vector is that of their figure 11, eight)
(points with inner knots at 0.2, 0.4, 0.6 and 0.8. The points are our own, since)
(the paper prints them as a picture only.)

(How F follows from the cut: radius 5 mm, 2 teeth, feed per tooth 0.5 mm. At)
(6000 rpm the teeth pass 12000 times a minute: F = 0.5 * 2 * 6000 = 6000.)
(The next line of the surface would be 0.5 mm beside this one, in Y.)

S6000 M03
G00 X0 Y0 Z0

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
M05
G00 Z15
X0
M30
