(expect 3 blocks, 13.766 mm, to 2 4 0)
G21 G90 G17 F600
G0 X-2 Y4
G5.1 X2 I2 J-8
M2
