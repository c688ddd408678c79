(expect SC2304 2:1, SC2304 3:1)
o1 endwhile
o2 endrepeat
M30
