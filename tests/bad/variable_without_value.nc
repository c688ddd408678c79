(expect SC1024 2:6, SC1024 3:9)
G00 X#<Depth> Y2
#1=[2 * #<_depth>]
M30
