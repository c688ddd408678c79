(leaves the travel of the built-in mill twice)
G90 G21 G01 F6000
X10
 X1010.5
X0
Y-1200
M30
