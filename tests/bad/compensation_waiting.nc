(expect SC2151 5:1)
F600 G41.1 D10
G01 X20
o1 repeat [5001]
Z1
Z2
o1 endrepeat
Y20
G40 X0
M30
