o<square> sub
#<side> = #1
G91
G1 F100 X#<side>
Y#<side>
X-#<side>
Y-#<side>
G90
o<square> endsub
o<square> call [10]
o<square> call [20]
M2
