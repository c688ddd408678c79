(expect 4 blocks, 21.566 mm, to 20 -2.5 0)
G 2 1 G 9 0
G 0 X 1 0 . 5 Y - 2 . 5
G0 1 X 1	2 F 1 0 0
G02 X 2 0 R 5
M 3 0
