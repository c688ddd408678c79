(expect SC2301 4:1, SC2301 5:1, SC2301 6:7)
o<pocket> sub
o<pocket> endsub
o<poket> call
o100 call [1] [2]
G0 X1 M98 P7
M30
