(expect 6 blocks, 64.925 mm, to 0 30 0)
G21 G90 F600
G01 X20. ,R5.
Y30. , C 5.
X0.
M30
