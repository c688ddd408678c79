(expect SC1030 2:7, SC1030 3:7)
G00 X#<depth
G00 X#<>
M30
