(expect 6 blocks, 5 mm, to 5 0 0)
/ G00 X1
G00 X2
/2 G00 X3
N40 / G00 X4
/N50 G00 X5
/ (a comment)
M30
