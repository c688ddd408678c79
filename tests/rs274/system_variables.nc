F100
G0 X10 Y20 Z30
G1 X[#5420+1] Y[#5421+1] Z[#5422+1]
X[#<_x>+1] Y[#<_y>+1] Z[#<_z>+1]
G10 L2 P1 X5 Y6 Z7
X#5220
X[#<_coord_system>/10]
Y[#<_metric>] Z[#<_imperial>]
X[#<_absolute>] Y[#<_incremental>]
X[#<_plane>/10] 
X[#<_motion_mode>/10]
X[#<_feed>] Y[#<_rpm>]
X[#<_spindle_on>] Y[#<_mist>] Z[#<_flood>]
X[#<_inverse_time>] Y[#<_units_per_minute>] Z[#<_units_per_rev>]
X[#<_ccomp>/10]
X[#<_vmajor>/1000]
M2
