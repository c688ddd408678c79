(expect 7 blocks, 10.5 mm, to 2 2.5 2)
o<ramp> sub
  o1 if [#1 GT 3]
    G1 X#1 F200
  o1 elseif [#1 GT 2]
    G1 Y#1 F300
  o1 else
    o2 do
      #1=[#1+0.5]
      o3 if [#1 EQ 1]
        o2 continue
      o3 endif
      G1 Z#1 F100
    o2 while [#1 LT 2]
  o1 endif
  o<ramp> return [#1]
o<ramp> endsub
o<Ramp> call [4]
O<RAMP>CALL[2.5]
  o < r a m p > c a l l [ 0 ] (blanks count nowhere)
N10 o9 repeat [2] ; a comment
/N20 G0 X#<_value>
o9 endrepeat
M2
