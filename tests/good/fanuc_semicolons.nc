%;
O1234 (EOB SHOWN);
N1 G21 G90;
N2 G00 X10. Y10.;
N3 G01 X20. F100.;
N4 M30;
% (expect 3 blocks, 24.142 mm, to 20 10 0)
