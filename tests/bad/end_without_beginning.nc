(expect SC2304 2:1)
o1 endwhile
o2 endrepeat
M30
