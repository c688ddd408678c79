G00 X1
M30
this is never read (nor this
#1=2
