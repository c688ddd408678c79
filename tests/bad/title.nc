part (expect SC1020 1:1) one
%
G00 X1
M30
%
