(SPDX-License-Identifier: MIT)
(04  HELICES)
(An arc whose end is deeper or higher than its start is a helix. F is the speed)
(along the helix, not only in its plane.)

G00 X20 Y0 Z0
(One full turn about the origin, 2 mm down. Circles of the tool into the material)
(like this one are gentler than a plunge.)
G03 X20 Y0 Z-2 I-20 J0 F6000
G03 X20 Y0 Z-4 I-20 J0
(The last turn stays level and cleans the floor.)
G03 X20 Y0 I-20 J0
(Out of the cut: half a turn inwards and up. The circle is so small that the axes)
(cannot keep 100 mm/s on it; the trace shows acceleration as the limit.)
G03 X10 Y0 Z-2 I-5 J0
G00 Z0
G00 X0 Y0
M30
