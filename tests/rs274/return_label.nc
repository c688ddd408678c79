o100 sub
G0 X1
o5 while [#1 GT 0]
o5   return [3]
o5 endwhile
G0 X2
o100 endsub
o200 sub
o77 return [4]
G0 X9
o200 endsub
o100 call [1]
G0 Y#<_value>
o200 call
G0 Y#<_value>
M2
