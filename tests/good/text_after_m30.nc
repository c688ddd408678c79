(expect 2 blocks, 1 mm, to 1 0 0)
G00 X1
M30
this is never read (nor this
#1=2
