(SPDX-License-Identifier: MIT)
(06  INCHES AND DISTANCES)
(G20: lengths are in inches and feeds in inches per minute. G21: back to mm.)
(The change applies to every word of its own line and after it. Inside softcnc and in)
(every output all lengths are in millimetres.)

G20
G00 X1 Y1            (25.4 mm each)
G01 X2 F40           (40 inches a minute, 1016 mm/min)
G21
G01 Y50.8 F1000      (millimetres again: the same as Y2 in inches)

(G91: coordinates are distances from where the tool is. G90: positions again.)
(Useful for patterns: the same four lines cut a slot wherever the tool is.)
G91
G00 X10
G01 Y-10
G00 X5
G01 Y10
G90

(I, J and K of an arc are distances in both.)
G02 X50.8 Y35.8 I-15 J0
G00 X0 Y0
M30
