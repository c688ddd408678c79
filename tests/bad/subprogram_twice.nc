(expect SC2314 4:1)
o1 sub
o1 endsub
o1 sub
o1 endsub
o2 call
M30
o2 sub
o2 endsub
