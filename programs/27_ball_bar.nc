(SPDX-License-Identifier: MIT)
(27  THE CIRCULAR TEST)
(Two circles of ISO 230-4, one in each direction: what a ball bar measures. Half a turn leads in)
(and out, so that the machine is up to its speed on the whole turn in the middle.)
(softcnc run 27_ball_bar.nc --trace ball_bar.csv, then softcnc circle ball_bar.csv shows how round)
(they are: docs/circle.md.)

F1000
G00 X50 Y0
G03 X-50 Y0 I-50 J0  (in)
G03 X-50 Y0 I50 J0   (the turn that counts)
G03 X50 Y0 I50 J0    (out)
G02 X-50 Y0 I-50 J0
G02 X-50 Y0 I50 J0
G02 X50 Y0 I50 J0
M30
