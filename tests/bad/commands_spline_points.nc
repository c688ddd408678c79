(expect SC2353 5:15, SC2351 6:11, SC2353 8:1, SC2353 10:1)
(a number too many; a point twice; ended by a command, by the file)
f 600
l 1 0
s 2 1 1  2 2  3 (3)
s 3 1 1   0 0   5 5
l 1 1
s 2 1 1
l 1 0
s 3 4 0
  9
