(expect 8 blocks, 111.81 mm, to 45 27 0)
; line, arcs, spline
f 1200
l 20 0
l 0 10
pcw 10 0 5 0
pccw 0 12 0 6
dcaw -90 90 4
dcw 90 -90 4
s 3 5 5 5 -5 5 5
