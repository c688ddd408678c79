(expect SC2205 4:0)
%
G00 X1
%
what follows is no program
