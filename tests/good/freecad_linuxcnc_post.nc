(expect 18 blocks, 148.208 mm, to -2.5 0 16)
(Exported by FreeCAD)
(Post Processor: linuxcnc_post)
(Output Time:2024-03-01 10:12:13.123456)
(begin preamble)
G17 G54 G40 G49 G80 G90
G21
(begin operation: Fixture)
(machine units: mm/min)
(finish operation: Fixture)
(begin operation: TC: Default Tool)
(machine units: mm/min)
(TC: Default Tool)
(begin toolchange)
( M6 T1 )
M5
T1 M6
M3 S1000
(finish operation: TC: Default Tool)
(begin operation: Profile)
(Profile)
(Compensated Tool Path. Diameter: 5.0)
G0 Z16.000000
G0 X-2.500000 Y0.000000
G0 Z13.000000
G1 X-2.500000 Y0.000000 Z9.000000 F300.000
G1 X-2.500000 Y20.000000 Z9.000000 F600.000
G2 X0.000000 Y22.500000 Z9.000000 I2.500000 J0.000000 F600.000
G1 X30.000000 Y22.500000 Z9.000000
G2 X32.500000 Y20.000000 Z9.000000 I0.000000 J-2.500000
G1 X32.500000 Y0.000000
G2 X30.000000 Y-2.500000 I-2.500000 J0.000000
G1 X0.000000 Y-2.500000
G2 X-2.500000 Y0.000000 I0.000000 J2.500000
G0 Z16.000000
(finish operation: Profile)
(begin postamble)
M05
G17 G54 G90 G80 G40
M2
