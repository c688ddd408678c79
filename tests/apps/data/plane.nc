(a plane of 6 x 3 mm, line by line: 0.5 mm per tooth of two, 0.5 mm from line to line)
T1 M06
S600 M03
#1 = 0
o1 while [#1 LT 7]
  G00 Z2
  G00 X0 Y[#1 * 0.5]
  G00 Z0
  G01 X6 F600
  #1 = [#1 + 1]
o1 endwhile
G00 Z2
M05
M30
