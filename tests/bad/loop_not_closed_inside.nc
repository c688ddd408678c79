(expect SC2302 3:1)
o1 repeat [2]
o2 do
G0 X1
o1 endrepeat
M30
