(SPDX-License-Identifier: MIT)
(12  DWELL, SPINDLE, TOOL, COOLANT)
(Besides moving, a program switches things. All of them happen at rest: the machine)
(stops before such a block, and goes on after it.)

T1 M06               (T chooses the tool, M06 changes to it)
S3000 M03            (3000 rpm, clockwise; M04 turns the other way)
M08                  (flood coolant; M07 is mist)

G00 X20 Y20
G01 Z-2 F300
G04 P0.5             (dwell: half a second to clean the bottom of the hole)
G00 Z5
X40
G01 Z-2
G04 P0.5
G00 Z5

S1500                (while the spindle turns, S alone changes its speed)
G61.1                (from here on every block ends at rest)
G01 X40 Y40 F1200
X20
G64                  (and here no longer: corners are rounded by a hundredth of a mm)

N900 M05             (spindle off)
M09                  (coolant off)
G00 X0 Y0 Z0
M30
