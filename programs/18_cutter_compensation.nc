(SPDX-License-Identifier: MIT)
(18  CUTTER COMPENSATION)
(The program gives the contour as the drawing has it; the control leads the tool beside)
(it, by its radius. G41 runs it left of the contour, seen in the direction of motion,)
(G42 right of it, G40 ends that. Left is down-milling, for a tool that turns clockwise.)

G10 L1 P1 Z0 R3      (tool 1: no length, a radius of 3 mm; most often the tool table has it)
T1 M06
S6000 M03

G00 X0 Y-15 Z5       (begin away from the contour: the entry must be longer than the radius)
G01 Z-2 F300
G41 D1 X0 Y0 F900    (D1: by the radius of tool 1. Straight on into the next line, all controls enter alike)
Y30                  (clockwise around a part: left is outside)
G02 X10 Y40 I10 J0   (an outside arc: the tool's own has a radius of 13 mm)
G01 X50              (an outside corner: the tool goes round it on an arc)
Y25
X40                  (here is an inside corner; the tool stops short where its sides meet)
Y15
G03 X50 Y5 I10 J0    (an inside arc must be larger than the tool: 10 mm, so the tool's is 7 mm)
G01 Y0
X0                   (back along the bottom)
G40 X-15 Y-15        (exit: this line ends with the tool's centre where the program says)

G00 Z5
X20 Y24
G01 Z-2 F300
G42.1 D5 X26 Y24 F900     (G41.1 and G42.1 take the diameter itself: D5, whatever the tool)
G02 X30 Y20 I0 J-4   (a quarter circle leads into the contour without a mark)
X30 Y20 I-8 J0       (clockwise, the tool on the right: around the inside of a round pocket)
X26 Y16 I-4 J0       (and out again)
G40 G01 X20 Y16
G00 Z5

M05
G00 X0 Y0
M30
