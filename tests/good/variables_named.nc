(expect 8 blocks, 140 mm, to 0 0 5)
G21 G90
#<width> = 40
#<_depth> = [-2.5]
#<SafeHeight>=5
F500
G0 X0 Y0 Z#<safeheight>
G1 Z#<_depth>
X#<width>
Y[#<width>/2]
X0
Y0
G0 Z#<SAFEHEIGHT>
M2
