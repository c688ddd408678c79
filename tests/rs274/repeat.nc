#1=0
o1 repeat [3]
#1=[#1+1]
G0 X#1
o2 repeat [2]
G91 G0 Y1
o2 endrepeat
G90
o1 endrepeat
o3 repeat [0]
G0 X99
o3 endrepeat
M2
