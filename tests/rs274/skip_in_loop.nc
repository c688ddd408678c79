o1 repeat [2]
/G91 G0 X1
G90
o1 endrepeat
M2
