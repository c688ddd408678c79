o100 sub
#1 = 99
#30 = 5
#31 = 6
#<mine> = 3
G0 X#1 Y#30
o100 endsub
#1 = 1
#30 = 2
#31 = 3
o100 call [7]
G0 X#1 Y#30 Z#31
M2
