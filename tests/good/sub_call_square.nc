(expect 11 blocks, 88.071 mm, to 30 5 0)
o100 sub
  G91 G1 X#1
  Y#1
  X-#1
  Y-#1
  G90
o100 endsub
G21 G90 F600
G0 X5 Y5
o100 call [10]
G0 X30 Y5
o100 call [4]
M2
