(expect SC2150 6:1)
F600 G0 X-10 Y2
G41.1 D4 G1 X0 Y0
G1 X40
(the arc comes back to the line by less than the tool's width)
G3 X20.05 Y1 R10
G1 Y20
G40 G1 X10 Y30
M2
