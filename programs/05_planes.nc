(SPDX-License-Identifier: MIT)
(05  THE THREE PLANES)
(An arc lies in the plane chosen before it: G17 X Y as at the start, G18 Z X,)
(G19 Y Z. The centre is given by the two letters of the plane, I to X, J to Y,)
(K to Z, or by R.)

G00 X0 Y0 Z0

(G18. Clockwise and counter-clockwise are seen against the axis across the plane,)
(here Y, with Z as the first axis and X as the second. Drawn with X to the right)
(and Z upwards, as seen from the front of a mill, that is the mirror image: G02)
(looks counter-clockwise. This one is a valley of radius 10.)
G18
G02 X20 Z0 I10 K0 F1500

(G19: the same across, in Y and Z. Here Y to the right and Z upwards are the first)
(and the second axis, and the picture is the usual one: G03 runs through a valley.)
G19
G03 Y20 Z0 J10 K0

(A helix works in every plane: in G18 it goes along Y.)
G18
G03 X0 Z0 Y0 R10
G17
M30
