(SPDX-License-Identifier: MIT)
(14  LOOPS AND SUBPROGRAMS)
(A subprogram is written once and called with other numbers each time; a loop runs its)
(lines again. A number after # is a variable: #1, #2 ... are those of the call.)

o100 sub             (a hole: X, Y, depth, depth of one peck)
  G00 X#1 Y#2
  G00 Z2
  #5=0
  o101 while [#5 GT #3]
    #5=[#5-#4]
    o102 if [#5 LT #3]
      #5=#3            (the last peck is not deeper than the hole)
    o102 endif
    G01 Z#5 F120
    G00 Z2
  o101 endwhile
  G00 Z10
o100 endsub [#2+1]   (what it gives back is #<_value>)

G00 Z10
#10=0
o1 repeat [6]        (a circle of six holes)
  o100 call [30*COS[#10]] [30*SIN[#10]] [-7] [3]
  #10=[#10+60]
o1 endrepeat

#11=0
o2 do                (and a row, until Y is beyond 20)
  o100 call [50] [#11] [-4] [4]
  #11=[#<_value>+9]
o2 while [#11 LE 20]

G00 X0 Y0
M30
