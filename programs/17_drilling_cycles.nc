(SPDX-License-Identifier: MIT)
(17  DRILLING CYCLES)
(A cycle makes a whole hole in one line: a rapid over the hole, a rapid down to R, the)
(feed to Z, and out again. It stays in force, with all its words, until G80 or a motion)
(code: a line with X or Y alone is the next hole. Another cycle needs its own Z and R.)

T1 M06
S2000 M03
G00 Z20              (the height from which the first hole is begun)

G99 G81 X10 Y10 Z-4 R2 F300   (drill to Z-4; G99: out to R only, for the next hole is near)
X25
X40
G98 Y25              (G98: out to Z20, where the series began, over a clamp after this hole)
G99 X25
X10

G83 X10 Y40 Z-14 Q5 R2        (deep: pecks of 5 mm, each time out of the hole)
G73 X25 Z-14 Q5 R2            (the same, but it only lifts a little to break the chip)
G85 X40 Z-6 R2                (bore: out at the feed as well, which leaves no mark)

S300
G84 X10 Y10 Z-3 R2 F300       (tap: down, the spindle turns back, and out; S times the pitch is F)
X25
X40
G80                  (the end of it: X and Y move again as they always do)

S2000
G00 Z10
X50 Y0
G91                  (in steps: R counts from Z10, Z from R)
G98 G81 Y10 Z-6 R-8 F300 L3   (L3: three holes, each 10 mm on from the one before)
G90 G80

M05
G00 X0 Y0 Z20
M30
