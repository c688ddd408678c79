%
(expect 3 blocks, 12.071 mm, to 0 5 0)
O77 (CRLF)
G21 G90
G00 X5. Y5.

G01 X0. F100.
M30
%
