(expect 3 blocks, 6.827 mm, to 0 1 0)
G0 X0 Y0
F100
G5.2 P1 L3
     X0 Y1 P1
     X2 Y2 P1
     X2 Y0 P1
     X0 Y0 P2
G5.3
G0 X0 Y1
M2
