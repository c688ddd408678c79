(SPDX-License-Identifier: MIT)
(15  SPLINES: SMOOTH CURVES WITHOUT KNOTS)
(A NURBS says everything a curve can be, and asks for a lot of words. Four shorter)
(forms lead to the same exact curves; none of them is chopped into lines.)

(FIRST: through points. G06.1 draws one smooth curve from where the tool is)
(through every point that follows, one a line, as a thin ruler bent around pins)
(would lie. It ends where another motion code begins.)
G00 X0 Y0
G06.1 X10 Y15 F3000
      X30 Y20
      X45 Y5
      X60 Y10

(SECOND: the handles of a drawing program. G05 is a cubic: I J is the handle at its)
(start, P Q the one at its end. A second G05 without I J goes on in the same)
(direction, so that there is no corner and no stop between them.)
G05 X80 Y10 I5 J-10 P-5 Q-15
G05 X100 Y10 P-8 Q12

(One handle is enough for the quadratic G05.1; both lie in the plane in force.)
G05.1 X110 Y-10 I10 J-5

(THIRD: by control points. Between G05.2 and G05.3 every line is a magnet that pulls)
(at the curve, P its strength. L4 makes it a cubic; without L it is a quadratic.)
G05.2 L4 P1
      X100 Y-35 P1
      X70  Y-15 P2
      X40  Y-45 P1
      X0   Y-30 P1
G05.3

(LAST: a spline may leave the plane: a ramp that swings up to where it began.)
G06.1 X-12 Y-20 Z1
      X-12 Y-8  Z3
      X0   Y0   Z5
G00 Z0
M30
