F100
#1 = 5
G1 X#1
#2 = [#1 * 2]
Y#2
#3=7 #4=8 X#3
X#3 Y#4
#1=#2
X#1
#[3+2]=11
X#5
#6=1
X##6
#<depth>=3.5
X#<depth>
#<_global> = 4
Y#<_global>
# <two words> = 6
X#<twowords>
#100=1 #100=[#100+1] X#100
X#100
X-#100
#31=2
X#31
G#6 Z3
M2
