(saved by hand)

%
G00 X1
M30
%
