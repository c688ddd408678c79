(expect 3 blocks, 32.468 mm, to 20 0 10)
F600 G00 X0 Y0 Z0
N10 G06.2 K0. X0. Y0. (first)
N20 K0. X5. Y5.

(a comment)
N30 X10. Y5. K0.
; another
N40 R.5 Y0. X15. K0.
N50 K.5 X20.
N60 K1.
N65
N70 K1.
N80 K1. (nearly)
N90 K1.
N100 G00 Z10.
M30
