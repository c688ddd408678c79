(SPDX-License-Identifier: MIT)
(28  FINDING A CORNER)
(A probe finds the left and the front face of a block and its top, each fast and then slowly, and)
(makes the corner where they meet the origin of G54. 28_probe_corner.toml says where the block is:)
(a run of a simulated mill touches it there. docs/probing.md)
G21 G90 G17 G49 G94
#<_radius> = 2  (of the ball)

o<edge> sub  (#1: axis, 0 is X, 1 is Y, towards larger coordinates)
  G91
  o1 if [#1 EQ 0]
    G38.2 X40 F600
    G01 X-1
    G38.2 X2 F50
    G01 X-3 F600
  o1 else
    G38.2 Y40 F600
    G01 Y-1
    G38.2 Y2 F50
    G01 Y-3 F600
  o1 endif
  G90
o<edge> endsub

G10 L2 P1 X0 Y0 Z0
G00 X100 Y100
Z-45
o<edge> call [0]
#<left> = [#5061 + #<_radius>]
G00 Z-30
X150 Y60
Z-45
o<edge> call [1]
#<front> = [#5062 + #<_radius>]
G00 Z-30
X130 Y90
G38.2 Z-50 F600
G91 G01 Z1
G38.2 Z-2 F50
G90
#<top> = #5063
G10 L2 P1 X#<left> Y#<front> Z#<top>
G00 Z10
X0 Y0
M30
