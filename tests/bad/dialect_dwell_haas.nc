(expect SC2384 2:5; haas; check)
G04 P2.
M30
