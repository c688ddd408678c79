(SPDX-License-Identifier: MIT)
(30  TOOL LENGTHS BY A SETTER)
(Each tool goes down onto the setter, whose top is at Z-180 in machine coordinates, and its length)
(goes into the tool table. 30_tool_length.toml says how long the tools are. docs/probing.md)
G21 G90 G17 G49 G94
#<_setter_top> = -180

o<measure> sub  (#1: the tool)
  T#1 M06
  G53 G00 Z0
  G53 G00 X-300 Y-200
  G38.2 Z-200 F800
  G91 G01 Z1
  G38.2 Z-2 F40
  G90
  G10 L1 P#1 Z[#5063 - #<_setter_top>]
  G53 G00 Z0
o<measure> endsub

o<measure> call [1]
o<measure> call [2]
G43 H2
G00 X0 Y0
G00 Z-100  (the tip of the second tool)
M30
