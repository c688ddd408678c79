(expect SC1024 2:6, SC1024 3:9, SC1024 4:2, SC1024 5:6)
G00 X#<Depth> Y2
#1=[2 * #<_depth>]
F#<_probe_rapid_feed_per_min>
G00 X#<_aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa>
M30
