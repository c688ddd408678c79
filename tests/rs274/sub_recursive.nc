o100 sub
o101 if [#1 GT 0]
G0 X#1
o100 call [#1 - 1]
G0 Y#1
o101 endif
o100 endsub
o100 call [4]
M2
