(expect 3 blocks, 50 mm, to 25 25 0)
G21 G90
#1=10 #10=25
G0 X##1
G0 Y#[#1*1]
M2
