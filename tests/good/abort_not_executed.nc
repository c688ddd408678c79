(expect 3 blocks, 5 mm, to 5 0 0)
o1 if [0]
(ABORT,not in a branch that is not taken)
o1 endif
o2 if [1] (ABORT,not beside a statement)
(A BORT,not with a blank in the word)
(ABORT)
G00 X2 (ABORT,not the last comment) (of its line)
o2 endif
; (ABORT,not within a comment to the end of the line)
G00 X5
M2
(ABORT,not after the end)
