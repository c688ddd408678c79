%
O1000
(a comment) G0 (another) X1 (third)
; a line of its own

N5 G0 Y2 ; rest
/G0 Z3
   G0   X 7
(MSG, hello)
(debug, #5220)
M2
%
G0 X99
