(expect 7 blocks, 37.4 mm, to 37.4 0 0)
(the subprograms change modes as they like; the caller need not know)
G21 G90 G54 F300 S1000 M3
o<inch> call [1]
G1 X30
X37.4
M30
o<inch> sub
  M73 (the end restores)
  G20 G91 F20 S500
  G1 X#1
o<inch> endsub
