(BOM)
G21 G90 G0 X3 Y4
M2 (expect 2 blocks, 5 mm, to 3 4 0)
