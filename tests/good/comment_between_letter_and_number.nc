(expect 2 blocks, 10.198 mm, to 10 2 0)
G21 G90 G(motion)0 X(far)10 Y (near) 2
M2
