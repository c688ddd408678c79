(SPDX-License-Identifier: MIT)
(01  A LINE)
(A part program is read from top to bottom, one block a line. Text in round)
(brackets is for people. This one draws a single straight line.)
(When the program starts, the tool is at X0 Y0 Z0, lengths are millimetres, and)
(coordinates are positions, not distances: G21 and G90 are in force.)

(G01: straight to the point named, at the feed F in mm per minute along the path.)
(30 and 40 make a path of 50 mm; 3000 mm/min are 50 mm/s. No axis gets there at)
(once: Y, with four fifths of the path, accelerates with 1000 mm/s2 for 40 ms)
(at the beginning, and brakes for as long at the end. In the trace the limits are)
(acceleration, feed, acceleration.)
G01 X30 Y40 F3000

(M30: the end. Without it softcnc ends as well, and a note says so.)
M30
