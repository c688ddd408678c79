(expect 20 blocks, 72.263 mm, to 8.18 3.9 35)
(pcb2gcode style isolation routing, inches)
G94 ( Millimeters per minute feed rate. )
G20 ( Units == INCHES. )
G90 ( Absolute coordinates. )
S10000 ( RPM spindle speed. )
G64 ( path exactly )
M3 ( Spindle on clockwise. )
G04 P1 ( Wait for spindle )
G00 Z0.07874
G00 X0.12205 Y0.15354
G01 Z-0.00315 F6
X0.12205 Y0.24646 F12
X0.21497 Y0.24646
X0.21497 Y0.15354
X0.12205 Y0.15354
G00 Z0.07874
G00 X0.32205 Y0.15354
G01 Z-0.00315 F6
X0.32205 Y0.24646 F12
X0.41497 Y0.24646
X0.41497 Y0.15354
X0.32205 Y0.15354
G00 Z1.37795 ( All done -- retract )
M9
M5
M2
