(expect SC2316 83:1)
o1 sub
o2 if [1]
o3 if [1]
o4 if [1]
o5 if [1]
o6 if [1]
o7 if [1]
o8 if [1]
o9 if [1]
o10 if [1]
o11 if [1]
o12 if [1]
o13 if [1]
o14 if [1]
o15 if [1]
o16 if [1]
o17 if [1]
o18 if [1]
o19 if [1]
o20 if [1]
o21 if [1]
o22 if [1]
o23 if [1]
o24 if [1]
o25 if [1]
o26 if [1]
o27 if [1]
o28 if [1]
o29 if [1]
o30 if [1]
o31 if [1]
o32 if [1]
o33 if [1]
o34 if [1]
o35 if [1]
o36 if [1]
o37 if [1]
o38 if [1]
o39 if [1]
o40 if [1]
o41 if [1]
o42 if [1]
o43 if [1]
o44 if [1]
o45 if [1]
o46 if [1]
o47 if [1]
o48 if [1]
o49 if [1]
o50 if [1]
o51 if [1]
o52 if [1]
o53 if [1]
o54 if [1]
o55 if [1]
o56 if [1]
o57 if [1]
o58 if [1]
o59 if [1]
o60 if [1]
o61 if [1]
o62 if [1]
o63 if [1]
o64 if [1]
o65 if [1]
o66 if [1]
o67 if [1]
o68 if [1]
o69 if [1]
o70 if [1]
o71 if [1]
o72 if [1]
o73 if [1]
o74 if [1]
o75 if [1]
o76 if [1]
o77 if [1]
o78 if [1]
o79 if [1]
o80 if [1]
o81 if [1]
o82 if [1]
o83 if [1]
o84 if [1]
o85 if [1]
o86 if [1]
o87 if [1]
o88 if [1]
o89 if [1]
o90 if [1]
o91 if [1]
o92 if [1]
o93 if [1]
o94 if [1]
o95 if [1]
o96 if [1]
o97 if [1]
o98 if [1]
o99 if [1]
o100 if [1]
o101 if [1]
o102 if [1]
o103 if [1]
o104 if [1]
o105 if [1]
o106 if [1]
o107 if [1]
o108 if [1]
o109 if [1]
o110 if [1]
o111 if [1]
o112 if [1]
o113 if [1]
o114 if [1]
o115 if [1]
o116 if [1]
o117 if [1]
o118 if [1]
o119 if [1]
o120 if [1]
o121 if [1]
o122 if [1]
o123 if [1]
o124 if [1]
o125 if [1]
o126 if [1]
o127 if [1]
o128 if [1]
o129 if [1]
o130 if [1]
o131 if [1]
o132 if [1]
o133 if [1]
o134 if [1]
o135 if [1]
o136 if [1]
o137 if [1]
o138 if [1]
o139 if [1]
o140 if [1]
o141 if [1]
o142 if [1]
o143 if [1]
o144 if [1]
o145 if [1]
o146 if [1]
o147 if [1]
o148 if [1]
o149 if [1]
o150 if [1]
o151 if [1]
o152 if [1]
o153 if [1]
o154 if [1]
o155 if [1]
o156 if [1]
o157 if [1]
o158 if [1]
o159 if [1]
o160 if [1]
o161 if [1]
o1 call
o161 endif
o160 endif
o159 endif
o158 endif
o157 endif
o156 endif
o155 endif
o154 endif
o153 endif
o152 endif
o151 endif
o150 endif
o149 endif
o148 endif
o147 endif
o146 endif
o145 endif
o144 endif
o143 endif
o142 endif
o141 endif
o140 endif
o139 endif
o138 endif
o137 endif
o136 endif
o135 endif
o134 endif
o133 endif
o132 endif
o131 endif
o130 endif
o129 endif
o128 endif
o127 endif
o126 endif
o125 endif
o124 endif
o123 endif
o122 endif
o121 endif
o120 endif
o119 endif
o118 endif
o117 endif
o116 endif
o115 endif
o114 endif
o113 endif
o112 endif
o111 endif
o110 endif
o109 endif
o108 endif
o107 endif
o106 endif
o105 endif
o104 endif
o103 endif
o102 endif
o101 endif
o100 endif
o99 endif
o98 endif
o97 endif
o96 endif
o95 endif
o94 endif
o93 endif
o92 endif
o91 endif
o90 endif
o89 endif
o88 endif
o87 endif
o86 endif
o85 endif
o84 endif
o83 endif
o82 endif
o81 endif
o80 endif
o79 endif
o78 endif
o77 endif
o76 endif
o75 endif
o74 endif
o73 endif
o72 endif
o71 endif
o70 endif
o69 endif
o68 endif
o67 endif
o66 endif
o65 endif
o64 endif
o63 endif
o62 endif
o61 endif
o60 endif
o59 endif
o58 endif
o57 endif
o56 endif
o55 endif
o54 endif
o53 endif
o52 endif
o51 endif
o50 endif
o49 endif
o48 endif
o47 endif
o46 endif
o45 endif
o44 endif
o43 endif
o42 endif
o41 endif
o40 endif
o39 endif
o38 endif
o37 endif
o36 endif
o35 endif
o34 endif
o33 endif
o32 endif
o31 endif
o30 endif
o29 endif
o28 endif
o27 endif
o26 endif
o25 endif
o24 endif
o23 endif
o22 endif
o21 endif
o20 endif
o19 endif
o18 endif
o17 endif
o16 endif
o15 endif
o14 endif
o13 endif
o12 endif
o11 endif
o10 endif
o9 endif
o8 endif
o7 endif
o6 endif
o5 endif
o4 endif
o3 endif
o2 endif
o1 endsub
o1 call
M30
