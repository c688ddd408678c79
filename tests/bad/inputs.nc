(expect SC2244 2:1, SC2243 3:1; inputs: the machine has some)
M66 P0 L3 Q2.5
M52 P1
M30
