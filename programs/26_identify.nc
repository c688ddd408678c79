(SPDX-License-Identifier: MIT)
(26  IDENTIFY)
(Moves each axis by itself so that a trace tells what its drive is:)
(softcnc run programs/26_identify.nc --trace t.npz, then softcnc identify t.npz)
G21 G17 G90 G94
(the axis whose argument is 1 goes to #4)
o100 sub
  G1 X[#1*#4] Y[#2*#4] Z[#3*#4] F#5
o100 endsub
o200 sub
  (long moves at three speeds, for the gain of the position loop)
  #6 = 10
  o210 while [#6 LE 160]
    o100 call [#1] [#2] [#3] [#6/2] [60*#6]
    o100 call [#1] [#2] [#3] [-#6/2] [60*#6]
    #6 = [#6*4]
  o210 endwhile
  (ramps one after another, for the velocity loop)
  #7 = 0
  o220 while [#7 LT 8]
    o100 call [#1] [#2] [#3] [-76] [4800]
    o100 call [#1] [#2] [#3] [-80] [4800]
    #7 = [#7+1]
  o220 endwhile
  (slow reversals, for friction and backlash)
  #7 = 0
  o230 while [#7 LT 4]
    o100 call [#1] [#2] [#3] [-79] [300]
    o100 call [#1] [#2] [#3] [-80] [300]
    #7 = [#7+1]
  o230 endwhile
  #7 = 0
  o240 while [#7 LT 3]
    o100 call [#1] [#2] [#3] [-79.8] [30]
    o100 call [#1] [#2] [#3] [-80] [30]
    #7 = [#7+1]
  o240 endwhile
  o100 call [#1] [#2] [#3] [0] [6000]
o200 endsub
o200 call [1] [0] [0]
o200 call [0] [1] [0]
o200 call [0] [0] [1]
M30
