(expect 3 blocks, 20.756 mm, to 20 0.5 0)
  G 2 1   G 9 0
 G0 X 1 0 . 5   Y - 2 . 5
F 1 0 0
	G 0 1	X 2 0	Y . 5
M 3 0
