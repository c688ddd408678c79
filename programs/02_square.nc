(SPDX-License-Identifier: MIT)
(02  A SQUARE)
(G00 moves to a position: straight, and as fast as the axes allow.)
(G01 cuts: straight, at the feed. Both are modal, that is, they stay)
(in force until another code of their group: the lines with X or Y alone are G01.)
(So are coordinates: an axis that a line does not name stays where it is.)

G00 X10 Y10        (to the first corner: feed does not bind here, the axes do)
G01 Z-1 F600       (down into the material, slowly)
X50 F3000          (one side; the new feed applies from this block on)
Y50
X10
Y10
G00 Z0             (up again, as fast as the axis allows)

(The direction changes by 90 degrees at every corner, so the speed there is zero:)
(no axis can jump from one speed to another. A trace shows it as acceleration on)
(both sides of the corner. Rounding it off would be faster, but not a square.)
G00 X0 Y0
M30
