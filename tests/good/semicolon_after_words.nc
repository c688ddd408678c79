(expect 4 blocks, 3 mm, to 3 0 0)
G21;mm
G90;abs
G0 X1;one
X2;(two
X3;)three
M2;end
