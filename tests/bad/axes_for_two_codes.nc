(expect SC2110 3:8, SC2110 6:8, SC2110 7:11)
G00 X1 Y1
G92 X1 G01 Y5 F100
(where the program is now is not known: nothing is said of the arc)
G02 X20 Y20 I1 J0
G28 Z0 G00
G43.1 Z10 G00
M30
