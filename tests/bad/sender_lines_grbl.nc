(expect SC1055 2:1; grbl)
$H
X1*57
M2
