(expect 15 blocks, 175.096 mm, to -3 5 5)
(Created by hand, in the manner of an open CAM)
G90
G21
G17
(tool change to 6mm Carbide End Mill)
T1M06
S7000M03
(Profile)
G00X-3Y5
G00Z5
G01Z-2F100
Y20F200
G02X5Y28I8J0
G01X40
G02X48Y20I0J-8
G01Y5
G02X40Y-3I-8J0
G01X5
G02X-3Y5I0J8
G00Z5
M02
