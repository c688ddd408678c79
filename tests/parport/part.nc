(lines, an arc and a helix, for tests/parport/compare.py)
G21 G90 G17 F300 S1000
M03 M08
G00 X1 Y-1.5 Z0.3
G01 X3.07 Y0.02
X3 Y0
G02 X4 Y-1 I0 J-1
G03 X4 Y-1 Z-0.5 I-1 J0
G04 P0.2
G01 X0.013 Y0.5 Z0
G00 X0 Y0
M30
