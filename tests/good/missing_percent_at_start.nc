(expect 2 blocks, 1.414 mm, to 1 1 0)
O10
G21 G90
G0 X1 Y1
M30
%
