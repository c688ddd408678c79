(expect 19 blocks, 150.142 mm, to 40 10 10)
(Exported by FreeCAD)
(begin operation: Drilling expanded)
G17 G90 G21
T5 M6
M3 S1200
G0 Z10
G0 X10 Y10
G0 Z2
G1 Z-4 F90
G0 Z2
G0 Z-3.5
G1 Z-8 F90
G0 Z10
G0 X40 Y10
G0 Z2
G1 Z-4 F90
G0 Z2
G0 Z-3.5
G1 Z-8 F90
G0 Z10
M5
M2
