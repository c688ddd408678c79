(expect 2 blocks, 2.236 mm, to 1 2 0)
(a) N10 (b) G00 (c) X1 (d) Y2 (e) ; f ( g
()
( )
;
; only this
M30 (end)
