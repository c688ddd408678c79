

   
	
G00 X1


M30


