(expect SC2313 3:1)
o1 if [1]
o1 repeat [2]
o1 endrepeat
o1 endif
M30
