(expect 8 blocks, 217 mm, to 0 0 5)
; a square, by hand
g21 g90 g64
f600
g0 x0 y0 z5
g1 z-1          ; down
x50
y50
x0
y0
g0 z5
m2
