(expect SC2307 3:1)
o1 sub
o2 sub
o2 endsub
o1 endsub
M30
