(SPDX-License-Identifier: MIT)
(13  LINE, ARC, CURVE: THE MILL OF PAPER 003)
(Yang and Hong turned a manual mill into a numerically controlled one: two DC servo)
(motors with encoders, 5 mm ball screws, one pulse for every 2.5 um, at most)
(15 m/min. The file 13_paper003_shapes.toml beside this one is that mill; it has no)
(Z. They showed what it can do with three workpieces, a line, an arc and a curve.)
(Their sizes are not printed. Their input counts from where the tool is, so)
(these do as well: G91.)

G91
(Lines.)
G01 X20 F3000
Y10
X-20 Y-10

(Arcs: half a circle in each direction, an S.)
G00 X30
G03 X0 Y12 I0 J6
G02 X0 Y12 I0 J6

(A curve, in positions. Its first point is where the arcs end.)
G90
G06.2 P4 K0 X30 Y24
         K0 X40 Y40
         K0 X60 Y0
         K0 X75 Y35
         K1 X90 Y20
         K2
         K2
         K2
         K2
G00 X0 Y0
M30
