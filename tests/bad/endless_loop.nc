(expect SC2310 2:1; limit 1000)
o1 while [1]
o1 endwhile
M30
