(a) N10 (b) G00 (c) X1 (d) Y2 (e) ; f ( g
()
( )
;
; only this
M30 (end)
