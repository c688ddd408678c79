(expect 5 blocks, 49.124 mm, to 0 0 -2)
G21 G90 G17
G13 I5. Z-2. D0 F300.
M30
