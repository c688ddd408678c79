(expect 2 blocks, 7 mm, to 7 0 0)
o<add> sub
o<add> return [#1+#2]
o<add> endsub
G21 G90
o<add> call [3] [4]
G0 X#<_value>
M2
