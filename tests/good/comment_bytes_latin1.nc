(expect 2 blocks, 1 mm, to 1 0 0)
(Fräsen, Außen, µm, 45°)
G21 G90 G0 X1
; ÿþ€
M2
