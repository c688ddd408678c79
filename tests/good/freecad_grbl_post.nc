(expect 9 blocks, 99.51 mm, to 10 10 6)
(Exported by FreeCAD)
(Post Processor: grbl_post)
(Begin preamble)
G17 G90
G21
(Begin operation)
M3 S12000
G0 Z6.000
G0 X10.000 Y10.000
G1 Z-1.500 F120.000
G3 X10.000 Y10.000 Z-3.000 I5.000 J0.000 F400.000
G3 X10.000 Y10.000 I5.000 J0.000
G0 Z6.000
(Begin postamble)
M5
G17 G90
M2
