(expect SC2115 2:6, SC2115 7:1, SC2115 9:3)
F100 M72 G01 X1
M73
M72
M71
(what was saved is forgotten)
M72
o1 call
  M72
M30
o1 sub
o1 endsub
