(SPDX-License-Identifier: MIT)
(24  M CODES OF THE MACHINE, OUTPUTS AND INPUTS)
(The machine of this program is in 24_machine_codes.toml beside it. It says what M31,)
(M33, M88 and M101 do, which outputs and inputs there are, and which values the inputs)
(have in simulation. Its comments name the lines of this program.)

M31                  (the chip conveyor, an output, on)
M64 P1               (digital output 1 on, at once: the clamp closes)
M66 P0 L3 Q5         (wait until digital input 0 is on: clamped; 5 s at most)
o1 if [#5399 LT 0]
  (ABORT,the part is not clamped)
o1 endif

T1 M06
S3000 M03
M88                  (high pressure coolant)
G00 X10 Y10 Z2
G01 Z-1 F300
M67 E0 Q0.5          (analog output 0 is 0.5 when the next move begins)
X50 F1200
M62 P2               (and digital output 2 on, likewise)
Y40
M63 P2
X10
Y10
G00 Z20
M101 P1 Q2           (nothing is done here: the machine takes P and Q)
M66 E0               (an analog input is read at once: where to go)
G00 X[#5399] Y0
M05
M09
M65 P1               (the clamp opens)
M33                  (the conveyor off, after a while)
M30
