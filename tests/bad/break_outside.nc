(expect SC2305 3:1)
o1 repeat [1]
o2 break
o1 endrepeat
M30
