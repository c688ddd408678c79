(expect 2 blocks, 2.236 mm, to 1 2 0)
()
G21 G90 () G0 X1 ()Y2
(;)
; ()
;
M2 ()
