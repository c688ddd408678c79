%
(expect 2 blocks, 1 mm, to 1 0 0)
G00 X1
M30
%
anything (at all: $!? é
G99 X--1
