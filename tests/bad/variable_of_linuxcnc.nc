(expect SC1024 2:4, SC1024 3:4)
#1=#<_hal[spindle.0.speed-out]>
#2=#<_ini[AXIS_X]MAX_VELOCITY>
M30
