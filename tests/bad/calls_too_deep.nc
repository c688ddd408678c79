(expect SC2309 3:1)
o1 sub
o1 call
o1 endsub
o1 call
M30
