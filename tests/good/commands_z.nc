(expect 4 blocks, 34.54 mm, to 0 0 0)
f 300
l 0 0 5
l 10 10 -6
l -10 -10 1