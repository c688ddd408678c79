(expect SC2304 2:1)
END 1
M30
