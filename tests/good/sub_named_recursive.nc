(expect 5 blocks, 7 mm, to 1 0 0)
o<down> sub
o1 if [#1 GT 0]
G0 X#1
o<down> call [#1-1]
o1 endif
o<down> endsub
G21 G90
o<down> call [4]
M2
