(lines, arcs and a helix for tests/linuxcnc/compare.py; some 10 s at the pace of mill.toml)
G21 G90 G17 G61 F1200
S1200 M03 M08
G00 X4 Y3
G01 X14 Y3.3 Z-1
G02 X20 Y9 I0 J6 F900
G03 X20 Y9 Z-2 I-5 J0
G04 P0.25
M04 M07
G01 X19.9 Y9.1
X19.8 Y9.1 Z-1.9
X0.0013 Y-7 F1200
G64 P0.05
X10 Y-9
X0 Y-11
G00 X0 Y0 Z0
M30
