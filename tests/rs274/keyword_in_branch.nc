G91
G0 X1
o1 if [0]
  o2 turn
o1 endif
G0 Y1
M2
