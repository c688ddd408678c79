(expect 2 blocks, 1 mm, to 1 0 0)
(フライス加工, 铣削, Ø6 ½″, 🙂)
G21 G90 G0 X1 (→)
; – end
M2
