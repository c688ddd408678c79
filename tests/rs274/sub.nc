o100 sub
G1 F[#1*100] X#2 Y#3
o100 endsub
o100 call [1] [10] [20]
o100 call [2] [20] [30]
#1=5
o100 call [3] [#1] [#1+1]
G1 X#1
M2
