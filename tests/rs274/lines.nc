(straight moves, words in any order, modal codes)
G0 X10 Y20 Z5
G1 F600 X20
Y30
Z-2 X5
G0 Z10
X0 Y0
g01 x 1 0 . 5 y-.25 f1000
F250 X11 G1
N100 G1 X12
G1 G90 X13 F100 Y2
M2
