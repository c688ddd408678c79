o100 sub
o110 if [#1 GT 5]
o100 return [1]
o110 endif
G0 X#1
o100 endsub [2]
o100 call [3]
G0 Y[#<_value>]
o100 call [7]
G0 Y[#<_value>]
M2
