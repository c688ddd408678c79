(expect 16 blocks, 35 mm, to 3 -2 3)
( a spiral of lines )
g21 g17 g90 g94 g64
t1 m6 ( 3 mm )
s4500 m3
g0 z3
g0 x 0 y 0
g1 z -.5 f 100
x 1 f 300
y 1
x -1
y -1
x 2
y 2
x -2
y -2
x 3
; still down
g0 z3
m5
m2
