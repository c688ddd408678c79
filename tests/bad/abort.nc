(expect SC1031 5:6)
G00 X1 (abort, in another place)(than the last)
o1 if [1]
  ; (ABORT,not here)
  T1 ( abort, wrong tool )
o1 endif
G01 X1
