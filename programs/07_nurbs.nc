(SPDX-License-Identifier: MIT)
(07  A NURBS, WORD BY WORD)
(A NURBS is a smooth curve drawn by a few control points, which pull at it like)
(magnets. G06.2 gives it to the machine as it is, not chopped into short lines.)

(  P   order: the degree plus one. The default is P4, a cubic.)
(  X Y Z  one control point a line. The first is the position of the tool.)
(  R   weight of the point, default 1: the larger, the stronger it pulls.)
(  K   knot. A curve has as many knots as control points plus order: one in the)
(      line of each point, and order more, each alone on a line, which end it.)

(Knots say where along the curve one point hands over to the next. They never)
(decrease. The first order of them are equal, and so are the last: then the curve)
(begins in the first control point and ends in the last one.)

(FIRST: four points, order 4. 4 + 4 = 8 knots: four at 0 and four at 1. There is)
(nothing to hand over; it is the Bezier curve of these points.)
G00 X0 Y0
G06.2 P4 K0 X0 Y0 F3000
         K0 X10 Y30
         K0 X40 Y30
         K0 X50 Y0
         K1
         K1
         K1
         K1

(SECOND: what polynomials cannot do. Order 3 and a weight of the cosine of 45)
(degrees for the corner point give a quarter of a circle, exactly: a NURBS is a)
(ratio of polynomials. This one has radius 20 and its centre in X50 Y-20.)
G06.2 P3 K0 X50 Y0
         K0 X70 Y0 R0.7071067811865476
         K0 X70 Y-20
         K1
         K1
         K1

(THIRD: five points, order 4, one inner knot at 0.5. It is two cubics that meet at)
(that knot, with equal direction and curvature. An inner knot repeated twice would)
(allow a jump of curvature there, three times a corner.)
G06.2    K0 X70 Y-20
         K0 X70 Y-50
         K0 X35 Y-60 R2      (pulls twice as hard as the others)
         K0 X0 Y-40
         K0.5 X0 Y0
         K1
         K1
         K1
         K1
M30
