(expect 3 blocks, 91.547 mm, to 0 0 0)
f 900
s 5
10 2
10 -2   (a comment)

10 3
; another
10
-3
5 0
l -45 0
