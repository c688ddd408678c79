(expect 4 blocks, 31.916 mm, to 23 9 0)
F 600
L 10, 5
PCW 10,0,5,0
S 2, 1,1, 2,3
