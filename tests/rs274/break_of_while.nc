G91
o<left> while [1 EQ 1]
G0 X1
o<left> break
o<left> endwhile
#2 = 0
o2 do
#2 = [#2 + 1]
G0 Y1
o2 while [#2 LT 3]
M2
