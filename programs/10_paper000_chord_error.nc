(SPDX-License-Identifier: MIT)
(10  CHORD ERROR: THE SIMULATION OF PAPER 000)
(A machine that gets a point every 8 ms draws chords, not curves. Kim, Song and)
(Kwon limit how far a chord may lie off its curve by slowing down where it curves:)
(on a radius r a step of T seconds stays within e if F <= 2/T * sqrt[2 r e - e2].)
(Their simulation: T = 8 ms, F 2000 mm/min, e = 0.05 um. The file)
(10_paper000_chord_error.toml beside this one is that machine. Their curve is)
(printed as a picture only; the butterfly of page 08 replaces it. Like theirs it)
(is run clockwise.)

(Where the curve is tight, the trace names chord as the limit, and no row is further)
(off than 0.05 um. Things to try, after the name of this file:)
(  --set control.chord_tolerance_um=2           the coarser run of the paper)
(  --set control.interpolation=curvature3p      the paper's own method: curvature)
(        from the last three points. It looks back, while the curve is ahead; the)
(        summary shows by how much its chord error exceeds the tolerance.)

G00 X54.493 Y52.139

(begin curve butterfly F2000)
G06.2 P4 K0 X54.493 Y52.139 F2000
K0 X55.507 Y52.139
K0 X56.082 Y49.615
K0 X56.78 Y44.971 R1.2
K0.0083 X69.575 Y51.358
K0.015 X77.786 Y58.573
K0.0361 X90.526 Y67.081
K0.0855 X105.973 Y63.801
K0.1293 X100.4 Y47.326
K0.1509 X94.567 Y39.913
K0.1931 X92.369 Y30.485
K0.2273 X83.44 Y33.757 R2
K0.2435 X91.892 Y28.509
K0.2561 X89.444 Y20.393
K0.2692 X83.218 Y15.446 R5
K0.2889 X87.621 Y4.83 R3
K0.317 X80.945 Y9.267
K0.3316 X79.834 Y14.535 R1.1
K0.3482 X76.074 Y8.522
K0.3553 X70.183 Y12.55
K0.3649 X64.171 Y16.865
K0.3837 X59.993 Y22.122
K0.4005 X55.68 Y36.359
K0.4269 X56.925 Y24.995
K0.451 X59.765 Y19.828
K0.466 X54.493 Y14.94
K0.4891 X49.22 Y19.828
K0.5 X52.06 Y24.994
K0.5109 X53.305 Y36.359
K0.534 X48.992 Y22.122
K0.5489 X44.814 Y16.865
K0.5731 X38.802 Y12.551
K0.5994 X32.911 Y8.521
K0.6163 X29.152 Y14.535 R1.1
K0.6351 X28.04 Y9.267
K0.6447 X21.364 Y4.83 R3
K0.6518 X25.768 Y15.447 R5
K0.6683 X19.539 Y20.391
K0.683 X17.097 Y28.512
K0.7111 X25.537 Y33.75 R2
K0.7307 X16.602 Y30.496
K0.7439 X14.199 Y39.803
K0.7565 X8.668 Y47.408
K0.7729 X3 Y63.794
K0.8069 X18.465 Y67.084
K0.8491 X31.197 Y58.572
K0.8707 X39.411 Y51.358
K0.9145 X52.204 Y44.971 R1.2
K0.9639 X52.904 Y49.614
K0.985 X53.478 Y52.139
K0.9917 X54.492 Y52.139
K1
K1
K1
K1
(end curve)
M30
