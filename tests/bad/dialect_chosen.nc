(expect SC1058 2:0; auto)
#1=#2+1
M30
