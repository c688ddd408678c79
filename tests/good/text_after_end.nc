%
G00 X1
M30
%
anything (at all: $!? é
G99 X--1
