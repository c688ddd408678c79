(expect 5 blocks, 13.43 mm, to 0 0 0)
; from the words of LinuxCNC: a cubic, one that goes on, a quadratic
G21 G90 G17
G0 X0 Y0
F100
G5 I0 J3 P0 Q-3 X1 Y1
G5 P0 Q-3 X2 Y2
G5.1 X4 Y2 I1 J1
G1 X0 Y0
M2
