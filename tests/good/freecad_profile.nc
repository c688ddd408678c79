(expect 18 blocks, 231.85 mm, to -3 0 15)
(Exported by FreeCAD)
(Post Processor: linuxcnc_post)
(Output Time:2024-05-11 10:22:31)
(begin preamble)
G17 G54 G40 G49 G80 G90
G21
(begin operation: TC: 6mm Endmill)
(machine units: mm/min)
(TC: 6mm Endmill)
M5
M6 T2
G43 H2
M3 S8000
(finish operation: TC: 6mm Endmill)
(begin operation: Profile)
(machine units: mm/min)
(Profile)
(Compensated Tool Path. Diameter: 6.0)
G0 Z15.000
G0 X-3.000 Y0.000
G0 Z3.000
G1 X-3.000 Y0.000 Z-2.500 F120.000
G1 X-3.000 Y30.000 Z-2.500 F400.000
G2 X0.000 Y33.000 Z-2.500 I3.000 J0.000 F400.000
G1 X50.000 Y33.000 Z-2.500
G2 X53.000 Y30.000 Z-2.500 I0.000 J-3.000
G1 X53.000 Y0.000 Z-2.500
G2 X50.000 Y-3.000 Z-2.500 I-3.000 J0.000
G1 X0.000 Y-3.000 Z-2.500
G2 X-3.000 Y0.000 Z-2.500 I0.000 J3.000
G0 Z15.000
(finish operation: Profile)
(begin postamble)
M05
G17 G54 G90 G80 G40
M2
