%
(expect 2 blocks, 1 mm, to 1 0 0)
O1
G21 G90 G0 X1
M30
%
O2
G0 X2
M30
%
