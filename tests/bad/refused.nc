(expect SC2114 2:1, SC2114 3:1)
G33 Z-5 K1
G76 P1 Z-10 I-1 J0.2 K0.5
(where the axes are is not known)
M30
