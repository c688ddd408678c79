(expect 3 blocks, 7 mm, to 5 2 0)
o200 call [5]
M30
o200 sub
G0 X#1
o<inner> call
o200 endsub
o<inner> sub
G0 Y2
o<inner> endsub
