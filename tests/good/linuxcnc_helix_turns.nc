(expect 11 blocks, 113.458 mm, to 0 0 5)
(thread mill, three turns up)
G21 G90 G17 G94
G0 X0 Y0 Z5
M3 S3000
G0 Z-9
G1 X4 F300
G3 X4 Y0 Z-8 I-4 J0
G3 X4 Y0 Z-7 I-4 J0
G3 X4 Y0 Z-6 I-4 J0
G1 X0
G0 Z5
M5
M2
