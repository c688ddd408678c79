  %  
(expect 2 blocks, 2 mm, to 2 0 0)
G21 G90
G0 X2
M2
	%	
