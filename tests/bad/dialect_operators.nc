(expect SC1032 2:4, SC1032 3:4, SC1032 4:4; check)
#1=[6 AND 3]
#2=[-7 MOD 4]
#3=[1 EQ 1.00001]
M30
