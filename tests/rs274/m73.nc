o100 sub
M73
G91 G20
G0 X1
o100 endsub
G90 G21
o100 call
X5
o100 call
X6
M2
