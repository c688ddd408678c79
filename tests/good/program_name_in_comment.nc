%
(expect 2 blocks, 1 mm, to 1 0 0)
O0001(SHAFT SUPPORT, REV. B)
(QTY 12)
G21 G90 G0 X1.
M30
%
