# SPDX-License-Identifier: MIT
"""Programs by a grammar and a seed: valid ones, and the same with one line broken.

The same seed makes the same program. Where a line needs the position (arcs, canned cycles), it is known: whatever moves the
coordinate system is followed by a move that names every axis.
"""
import math
import random
import re

AXES = {"G17": "XYZ", "G18": "ZXY", "G19": "YZX"}  # of each plane, and the axis across it
CENTERS = {"X": "I", "Y": "J", "Z": "K"}
TOLD = ("motion_mode plane ccomp metric imperial absolute incremental inverse_time units_per_minute units_per_rev coord_system "
        "tool_offset feed rpm spindle_on spindle_cw mist flood retract_r_plane retract_old_z current_tool selected_tool "
        "feed_override speed_override x y z").split()
CHANGE = re.compile(r"M0?6", re.IGNORECASE)  # of the tool, which the preview of splines does not survive
SYSTEMS = ["G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"]


class Program:
    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.lines = []
        self.at = dict.fromkeys("XYZ", 0.0)  # in program coordinates and units
        self.plane, self.incremental, self.inch, self.rotated = "G17", False, False, False
        self.mode, self.labels = "G94", 100
        self.tool_changes = True
        self.behind = []  # programs that follow its end

    # Words

    def chance(self, part):
        return self.rng.random() < part

    def length(self, low=-60.0, high=60.0):
        """In the unit in force."""
        mm = self.rng.uniform(low, high)
        return round(mm / 25.4, 4) if self.inch else round(mm, 3)

    def number(self, value):
        """One of the ways to write it."""
        text = f"{value:.9f}".rstrip("0")
        if text.endswith("."):
            text = text if self.chance(0.5) else text[:-1]
        if text.startswith("0.") and len(text) > 2 and self.chance(0.3):
            text = text[1:]
        if value > 0 and self.chance(0.05):
            text = "+" + text
        if self.chance(0.03):
            text = f"[{text}+{self.rng.randint(0, 3)}*0]"
        return text

    def code(self, text):
        """G1 as G01 now and then."""
        if len(text) == 2 and self.chance(0.3):
            return f"{text[0]}0{text[1]}"
        return text

    def add(self, *words, shuffle=False):
        words = [self.code(word) if word[0] in "GM" else word for word in words if word]
        if shuffle:
            self.rng.shuffle(words)
        text = (" " if self.chance(0.8) else "").join(words)
        if self.chance(0.1):
            text = text.lower()
        if self.chance(0.05):
            text = f"N{len(self.lines) * 10} {text}"
        if self.chance(0.04):
            text += " (a comment)"
        if self.chance(0.03):
            text += " ; the rest"
        self.lines.append(text)

    def label(self):
        self.labels += 1
        return f"o{self.labels}"

    def feed(self):
        return "F" + self.number(self.length(100, 3000))

    def word(self, axis, to):
        """The coordinate that leads to `to`, which becomes the position."""
        value = to - self.at[axis] if self.incremental else to
        value = round(value, 9)  # as exact as an arc's length must be for its feed in G93
        self.at[axis] = self.at[axis] + value if self.incremental else value
        return axis + self.number(value)

    def everywhere(self):
        """A move that makes the position known, whatever was moved before."""
        self.lines.append("G90")
        self.incremental = False
        self.lines.append("G0 " + " ".join(self.word(a, self.length()) for a in "XYZ"))
        if self.mode == "G94":
            self.add("G1", self.feed(), self.word("X", self.length()))

    # Moves

    def line(self):
        axes = [a for a in "XYZ" if self.chance(0.6)] or ["X"]
        if self.mode == "G94" and self.chance(0.3):
            self.add("G0", *(self.word(a, self.length()) for a in axes), shuffle=True)
        else:
            feed = self.feed() if self.mode == "G93" or self.chance(0.3) else ""
            self.add("G1", feed, *(self.word(a, self.length()) for a in axes), shuffle=True)

    def lines_by_mode(self):
        self.add("G1", self.feed(), self.word("X", self.length()))
        for _ in range(self.rng.randint(1, 4)):
            self.add(self.feed() if self.mode == "G93" else "", self.word(self.rng.choice("XYZ"), self.length()))

    def choose_plane(self):
        self.plane = "G17" if self.rotated else self.rng.choice(list(AXES))
        self.add(self.plane)

    def arc(self):
        first, second, across = AXES[self.plane]
        radius = abs(self.length(2, 40))
        start, sweep = self.rng.uniform(0, 2 * math.pi), self.rng.uniform(0.2, 6)
        ccw = self.chance(0.5)
        full = self.chance(0.1)
        center = {first: round(-radius * math.cos(start), 5), second: round(-radius * math.sin(start), 5)}
        radius = math.hypot(center[first], center[second])
        start = math.atan2(-center[second], -center[first])
        angle = start + (sweep if ccw else -sweep)
        absolute = self.chance(0.15)
        if not full and self.mode != "G93" and self.chance(0.1):  # an end off the circle, up to a hundred times of what is allowed by itself
            radius += self.length(-3, 3) * self.rng.choice((0.01, 0.01, 0.1, 1))
        origin = dict(self.at)
        words = [CENTERS[a] + self.number(round(center[a] + (origin[a] if absolute else 0), 9))
                 for a in (first, second)]
        if not full:
            words += [self.word(a, origin[a] + center[a] + radius * f)
                      for a, f in ((first, math.cos(angle)), (second, math.sin(angle)))]
        if self.chance(0.25):
            words.append(self.word(across, self.length()))
        if self.chance(0.15):
            words.append(f"P{self.rng.randint(1, 3)}")
        if absolute:
            self.add("G90.1")
        self.add("G3" if ccw else "G2", self.feed() if self.mode == "G93" else "", *words, shuffle=True)
        if absolute:
            self.add("G91.1")

    def polar(self):
        """LinuxCNC's @ and ^. In G91 both add to what the position has, seen from the zero point."""
        if self.plane != "G17":
            self.plane = "G17"
            self.add("G17")
        if math.hypot(self.at["X"], self.at["Y"]) < 1e-3:
            self.everywhere()
        out = math.hypot(self.at["X"], self.at["Y"])
        angle = math.degrees(math.atan2(self.at["Y"], self.at["X"]))
        letters = self.rng.choice(("@^", "@", "^"))
        radius = self.length(2, 60) if "@" in letters else 0.0
        turn = round(self.rng.uniform(-360, 360), 3) if "^" in letters else 0.0
        if self.incremental:
            out, angle = out + radius, angle + turn
        else:
            out, angle = radius if "@" in letters else out, turn if "^" in letters else angle
        self.at["X"], self.at["Y"] = out * math.cos(math.radians(angle)), out * math.sin(math.radians(angle))
        words = [letter + self.number(radius if letter == "@" else turn) for letter in letters]
        if self.chance(0.3):
            words.append(self.word("Z", self.length()))
        feed = self.feed() if self.mode == "G93" else ""
        self.add("G1" if feed or self.chance(0.8) else "G0", feed, *words, shuffle=True)

    def arc_by_radius(self):
        first, second, across = AXES[self.plane]
        to = {a: self.at[a] + self.length(3, 30) * self.rng.choice((-1, 1)) for a in (first, second)}
        half = math.hypot(*(to[a] - self.at[a] for a in to)) / 2
        radius = math.ceil(half * self.rng.uniform(1.01, 3) * 1e4) / 1e4 * self.rng.choice((1, 1, -1))
        words = [self.word(a, to[a]) for a in to] + ["R" + self.number(radius)]
        if self.chance(0.2):
            words.append(self.word(across, self.length()))
        self.add(self.rng.choice(("G2", "G3")), self.feed() if self.mode == "G93" else "", *words, shuffle=True)

    # Modes

    def units(self):
        self.lines.append("G49")  # rs274 by itself forgets to convert a length in force: tool_length_units.nc
        self.inch = not self.inch
        factor = 1 / 25.4 if self.inch else 25.4
        self.at = {a: x * factor for a, x in self.at.items()}
        self.add("G20" if self.inch else "G21")
        self.everywhere()

    def distance(self):
        self.incremental = not self.incremental
        self.add("G91" if self.incremental else "G90")

    def feed_mode(self):
        self.mode = self.rng.choice(("G93", "G94", "G95"))
        if self.mode == "G93":
            self.add("G93")
        elif self.mode == "G95":
            self.add("M3", f"S{self.rng.randint(100, 3000)}")
            self.add("G95", "F" + self.number(self.length(0.01, 2) or 0.1))
        else:
            self.add("G94", self.feed())
        self.lines_by_mode()
        for _ in range(self.rng.randint(0, 2)):
            self.arc()
        if self.mode != "G94":
            self.mode = "G94"
            self.add("G94", self.feed())

    def path_control(self):
        self.add(self.rng.choice(("G61", "G61.1", "G64", "G64 P0", "G64 P0.01", "G64 P0.02 Q0.01")))

    def dwell(self):
        self.add("G4", "P" + self.number(round(self.rng.uniform(0, 3), 2)))

    def spindle(self):
        self.add(self.rng.choice(("M3 S1000", "S500 M4", "M5", "M8", "M7", "M9", "S1200", "M3 S800 M8", "M3", "S0",
                                  "M9 M4 S70")))

    def override(self):
        """Which overrides count; beside a move, before it."""
        code = self.rng.choice(("M48", "M49", "M50", "M50 P0", "M50 P1", "M51", "M51 P0", "M53 P0"))
        self.add(code)
        self.line()

    def change_tool(self):
        """With the spindle on or off: M6 stops it."""
        if not self.tool_changes:
            return
        tool = self.rng.randint(1, 6)
        if self.chance(0.5):
            self.spindle()
        if self.chance(0.2):
            self.lines.append(f"M61 Q{tool}")
        else:
            self.lines += [f"T{tool}", "M6"] if self.chance(0.5) else [f"T{tool} M6"]
        if self.chance(0.3):
            self.lines.append(f"G0 X[1+#<_spindle_on>+2*#<_spindle_cw>] Y#5400 Z[[#540{self.rng.randint(1, 3)} GT 0]*3]")
        if self.chance(0.4):
            self.add(self.rng.choice(("M3 S900", "M4", "S400 M3", f"M6 T{tool} M3", f"M6 M4 T{tool}")))
        self.everywhere()

    # Offsets

    def system(self):
        self.lines.append(self.rng.choice(SYSTEMS))
        self.rotated = any("R" in line.upper() for line in self.lines if "G10" in line)
        self.unrotated_plane()
        self.everywhere()

    def unrotated_plane(self):
        if self.rotated and self.plane != "G17":
            self.plane = "G17"
            self.lines.append("G17")

    def set_system(self):
        number, how = self.rng.randint(0, 9), self.rng.choice(("L2", "L2", "L20"))
        words = [f"{a}{self.length(-30, 30)}" for a in "XYZ" if self.chance(0.7)]
        if how == "L2" and self.chance(0.3):
            words.append(f"R{self.rng.randint(-180, 180)}")
            self.rotated = True
            self.unrotated_plane()
        self.lines.append(f"G10 {how} P{number} " + " ".join(words))
        self.everywhere()

    def shift(self):
        words = " ".join(f"{a}{self.length(-30, 30)}" for a in "XYZ" if self.chance(0.7)) or "X0"
        self.lines.append(self.rng.choice((f"G92 {words}", f"G92 {words}", f"G52 {words}", "G92.1", "G92.2", "G92.3")))
        self.everywhere()

    def tool_length(self):
        tool = self.rng.randint(1, 6)
        self.lines.append(self.rng.choice((
            f"G10 L1 P{tool} Z{self.length(0, 50)}\nG43 H{tool}", f"G43.1 Z{self.length(0, 50)}", "G49",
            f"G43.1 X{self.length(-9, 9)} Y{self.length(-9, 9)} Z{self.length(0, 50)}",
            f"G10 L1 P{tool} Z{self.length(0, 50)} X{self.length(-9, 9)}\nG49\nG43.2 H{tool}",
            f"G10 L10 P{tool} Z{self.length(0, 9)}\nG43 H{tool}", f"G10 L11 P{tool} Z{self.length(0, 9)}\nG43 H{tool}")))
        self.everywhere()

    def reference(self):
        self.lines += self.rng.choice((["G28"], ["G28.1", "G28"], ["G30"], ["G30.1", "G30"], ["G28 Z0"],
                                       [f"G28 X{self.length()} Y{self.length()}"],
                                       [f"G53 G0 X{self.length()} Z{self.length()}"],
                                       [f"G53 G1 F500 Y{self.length()}"]))
        self.everywhere()

    # Canned cycles

    def cycle(self):
        first, second, across = AXES[self.plane]
        high, low = self.length(1, 10), self.length(-20, -1)
        incremental = self.chance(0.25)
        self.lines.append("G91" if incremental else "G90")
        self.incremental = incremental
        self.add(self.rng.choice(("G98", "G99")))
        code = self.rng.choice(("G81", "G82", "G83", "G73", "G85", "G86", "G89", "G81", "G83"))
        if code == "G86":
            self.lines.append("M3 S500")
        words = {"G82": f"P{round(self.rng.uniform(0, 2), 2)}", "G89": f"P{round(self.rng.uniform(0, 2), 2)}",
                 "G86": f"P{round(self.rng.uniform(0, 2), 2)}",
                 "G83": f"Q{abs(self.length(1, 6))}", "G73": f"Q{abs(self.length(1, 6))}"}.get(code, "")
        repeats = f"L{self.rng.randint(1, 3)}" if self.chance(0.2) else ""
        self.lines.append(" ".join(filter(None, (
            code, f"{first}{self.length()}", f"{second}{self.length()}", f"{across}{low}", f"R{high}", words, repeats,
            self.feed()))))
        for _ in range(self.rng.randint(0, 3)):
            self.lines.append(f"{self.rng.choice((first, second))}{self.length()}")
        self.lines.append("G80")
        self.everywhere()

    def tap(self):
        """Taps, with overrides on or off before and after. In G18 and G19 rs274 goes along the wrong axes: tap_zx.nc."""
        self.plane = "G17"
        self.lines += ["G17", "G90", self.rng.choice(("G98", "G99"))]
        self.incremental = False
        if self.chance(0.4):
            self.override()
        code, on = self.rng.choice((("G84", "M3"), ("G74", "M4")))
        self.lines.append(f"{on} S{self.rng.randint(50, 900)}")
        if self.chance(0.1):  # the spindle is off or turns the wrong way: refused by both
            self.lines.append(self.rng.choice((f"M6 T{self.rng.randint(1, 6)}", "M5", "M3", "M4")))
        pause = f"P{round(self.rng.uniform(0, 2), 2)}" if self.chance(0.5) else ""
        self.lines.append(" ".join(filter(None, (
            code, f"X{self.length()}", f"Y{self.length()}", f"Z{self.length(-20, -1)}", f"R{self.length(1, 10)}", pause,
            self.feed()))))
        for _ in range(self.rng.randint(0, 2)):
            self.lines.append(f"{self.rng.choice('XY')}{self.length()}")
        self.lines.append("G80")
        self.everywhere()

    # Cutter compensation

    def contour(self):
        """Around a polygon of wide corners, tool outside or inside."""
        self.plane = "G17"
        self.lines += ["G17", "G90", "G40"]
        self.incremental = False
        count, size = self.rng.randint(3, 7), 40 / (25.4 if self.inch else 1)
        angles = sorted(self.rng.uniform(0, 2 * math.pi) for _ in range(count))
        corners = [(size * (1 + 0.4 * self.rng.random()) * math.cos(a), size * math.sin(a)) for a in angles]
        if self.chance(0.5):
            corners.reverse()
        on = self.rng.choice(("G41 D1", "G42 D1", "G41 D3", "G42 D2", f"G41.1 D{self.length(2, 8)}",
                              f"G42.1 D{self.length(2, 8)}"))
        x, y = corners[0]
        self.lines.append(f"G0 X{x * 2.2 + 1:.4f} Y{y * 2.2 + 2:.4f} Z{self.length()}")
        self.lines.append(f"{on}\nG1 F600 X{x:.4f} Y{y:.4f}")
        for x1, y1 in corners[1:] + corners[:1]:
            if self.chance(0.3):
                radius = math.hypot(x1 - x, y1 - y) * self.rng.uniform(0.6, 2)
                self.lines.append(f"{self.rng.choice(('G2', 'G3'))} X{x1:.4f} Y{y1:.4f} R{radius:.4f}")
            else:
                self.lines.append(f"G1 X{x1:.4f} Y{y1:.4f}" + (f" Z{self.length()}" if self.chance(0.1) else ""))
            x, y = float(f"{x1:.4f}"), float(f"{y1:.4f}")
            if self.chance(0.1):
                self.add(self.rng.choice(("M8", "M7", "M9", "M3 S900", "M5", "S1100", "G4 P0.3")))
        self.lines.append(f"G40\nG1 X{x * 2 + 3:.4f} Y{y * 2 - 4:.4f}")
        self.everywhere()

    # Programming

    def expression(self, depth=0):
        """A term, and its value as LinuxCNC works it out where nothing overflows."""
        if depth > 2 or self.chance(0.3):
            return self.rng.choice((f"{self.rng.uniform(0.1, 9):.3f}", f"#{self.rng.randint(1, 5)}", "#<size>"))
        a, b = self.expression(depth + 1), self.expression(depth + 1)
        return self.rng.choice((
            f"[{a} + {b}]", f"[{a} - {b}]", f"[{a} * {b}]", f"[{a} / [1 + ABS[{b}]]]", f"SIN[{a}]", f"COS[{a}]",
            f"ATAN[{a}]/[{b}]", f"SQRT[ABS[{a}]]", f"FIX[{a}]", f"FUP[{a}]", f"ROUND[{a}]", f"[{a} MOD [1 + ABS[{b}]]]",
            f"[{a} GT {b}]", f"[{a} LE {b}]", f"[{a} AND {b}]", f"[{a} OR {b}]", f"[{a} XOR {b}]", f"[{a} EQ {b}]",
            f"[ABS[{a}] ** 1.5]", f"LN[1 + ABS[{b}]]", f"EXP[{a} / [5 + ABS[{a}]]]", f"ACOS[SIN[{a}]]",
            f"ASIN[COS[{a}]]", f"TAN[{a}]", f"EXISTS[#<size>]", f"[{a} * {b} - {a} / 2]", f"[2 + {a} * 3 ** 2]"))

    def variables(self):
        for number in range(1, 6):
            self.lines.append(f"#{number} = {self.rng.uniform(-9, 9):.3f}")
        self.lines.append(f"#<size> = {self.rng.uniform(1, 20):.3f}")
        for _ in range(self.rng.randint(1, 5)):
            self.lines.append(f"G1 {self.feed()} X[{self.bounded(self.expression())}]")
            self.lines.append(f"#{self.rng.randint(1, 5)} = [{self.bounded(self.expression())}]")
        self.lines.append("#1 = 3 #2 = #1")
        self.lines.append("G1 Y[#1 + 0] Z#2")
        self.everywhere()

    def bounded(self, term):
        return f"ATAN[{term}]/[3]"

    def loop(self):
        o, kind = self.label(), self.rng.choice(("while", "do", "repeat", "if", "sub"))
        step = f"G91 G1 F500 X{self.length(1, 5)} Y{self.length(-5, 5)}"
        if kind == "while":
            self.lines += ["#20 = 0", f"{o} while [#20 LT {self.rng.randint(0, 4)}]", step, "#20 = [#20 + 1]",
                           f"{o} endwhile"]
        elif kind == "do":
            self.lines += ["#20 = 0", f"{o} do", step, "#20 = [#20 + 1]",
                           f"{o} while [#20 LT {self.rng.randint(0, 4)}]"]
        elif kind == "repeat":
            self.lines += [f"{o} repeat [{self.rng.randint(0, 4)}]", step, f"{o} endrepeat"]
        elif kind == "if":
            self.lines += [f"#20 = {self.rng.randint(0, 3)}", f"{o} if [#20 EQ 1]", step, f"{o} elseif [#20 EQ 2]",
                           "G91 G0 X1", f"{o} else", "G91 G0 Y1", f"{o} endif"]
        else:
            self.lines += [f"{o} sub", f"{o}9 if [#1 LT 0]", f"{o} return", f"{o}9 endif",
                           "G91 G1 F500 X#1 Y[#2 * 2]", f"{o} endsub"]
            for _ in range(self.rng.randint(1, 3)):
                self.lines.append(f"{o} call [{self.length(-5, 5)}] [{self.length(-5, 5)}]")
        self.everywhere()

    def step(self):
        return f"G91 G1 F500 X{self.length(1, 5)} Y{self.length(-5, 5)}"

    def nested(self):
        """A loop within a loop, left or gone on with in the middle."""
        outer, inner, condition = self.label(), self.label(), self.label()
        again = f"{inner} while [#22 LT {self.rng.randint(1, 5)}]"
        by_do = self.chance(0.5)
        # Behind the break of a `while` rs274 leaves the next `do` early: break_of_while.nc.
        leave = f"{inner} {self.rng.choice(('break', 'continue')) if by_do else 'continue'}"
        self.lines += ["#21 = 0", f"{outer} while [#21 LT {self.rng.randint(1, 4)}]", "#21 = [#21 + 1]", "#22 = 0",
                       f"{inner} do" if by_do else again, "#22 = [#22 + 1]",
                       f"{condition} if [#22 EQ {self.rng.randint(1, 4)}]", leave, f"{condition} endif", self.step(),
                       again if by_do else f"{inner} endwhile", self.step(), f"{outer} endwhile"]
        self.everywhere()

    def named_sub(self):
        """A subprogram with a name, locals, and a value that it returns; called by another one."""
        name, caller = f"o<s{self.labels}>", f"o<t {self.labels}>"
        self.labels += 1
        self.lines += [f"{name} sub", "#<local> = [#1 * 2]", "#31 = 7", "#<_all> = [#<_all> + 1]",
                       f"{name} return [#<local> + #2]", f"{name} endsub", f"{caller} sub", "#<local> = 3",
                       f"{name} call [#1] [#<local>]", "G91 G1 F300 X[#<_value> / 10] Y[#<local>] Z[#31 + 0]",
                       f"{caller} endsub", "#<_all> = 0"]
        for _ in range(self.rng.randint(1, 3)):
            self.lines.append(f"{caller} call [{self.length(-5, 5)}]")
        self.lines.append("G1 F300 X[#<_all>]")
        self.everywhere()

    def repeated_call(self):
        """M98 of a program behind the main one."""
        number = self.labels = self.labels + 1
        self.behind += [f"O{number}", self.step(), f"G1 Z{self.length(-5, 5)}", "M99"]
        self.lines.append(f"M98 P{number}" + self.rng.choice(("", " L2", " L3")))
        self.everywhere()

    def told(self):
        """What the interpreter tells of its own state."""
        self.lines.append(f"G1 F400 X[#<_{self.rng.choice(TOLD)}> / 10] Y[#54{self.rng.choice((20, 21, 22))}]")
        self.lines.append(f"G0 X#52{self.rng.choice((20, 10))} Z[#<_{self.rng.choice('xyz')}>]")
        self.everywhere()

    def kept_modes(self):
        """Modes put aside, changed and taken back."""
        back = "M72" if self.chance(0.7) else ""
        self.lines += ["M70", self.rng.choice(("G91", "G90")), self.rng.choice(("G20", "G21")), "G1 F55 X1.5"]
        if self.chance(0.5):  # rs274 does not restore M49: override_restored.nc
            self.lines.append(self.rng.choice(("M3 S70", "M4 S60", "M5", "M8", "M9", "M7", "S30")))
            self.lines.append("X1.75")
        if back:
            self.lines.append(back)
        else:
            self.inch = self.lines[-2] == "G20"
        self.lines.append(f"G1 F{self.length(100, 900)} X1.25")
        self.everywhere()

    # Splines

    def spline(self):
        self.plane = "G17"
        self.lines += ["G17", "G90", f"G1 {self.feed()} X{self.length()}"]
        self.everywhere()
        self.lines.append(f"G1 F700 Y{self.length()}")
        n = self.length
        kind = self.rng.choice(("cubic", "quadratic", "nurbs"))
        if kind == "cubic":
            self.lines.append(f"G5 I{n()} J{n()} P{n()} Q{n()} X{n()} Y{n()}")
            for _ in range(self.rng.randint(0, 2)):
                self.lines.append(f"G5 P{n()} Q{n()} X{n()} Y{n()}")
        elif kind == "quadratic":
            self.lines.append(f"G5.1 I{n()} J{n()} X{n()} Y{n()}")
        else:
            order = self.rng.randint(2, 5)
            self.lines.append(f"G5.2 P{self.rng.choice((1, 1, 0.5, 2))} L{order}")
            for _ in range(self.rng.randint(order, order + 4)):
                self.lines.append(f"X{n()} Y{n()} P{self.rng.choice((1, 1, 0.5, 2.5))}")
            self.lines.append("G5.3")
        self.everywhere()

    def text(self):
        ending = self.rng.choice(("M2", "M30", "m02", "M2"))
        lines = [*self.lines, ending, *self.behind]
        if self.chance(0.2):
            lines = ["%", *lines, "%"]
        return "\n".join(lines) + "\n"


SUBJECTS = {  # what a program is about: its statements, each as often as it stands here
    "lines": "line line line distance units dwell",
    "arcs": "arc arc arc arc_by_radius choose_plane line distance",
    "modes": "line arc feed_mode units distance path_control spindle override choose_plane",
    "offsets": "system set_system set_system shift shift line arc units distance",
    "tools": "change_tool change_tool spindle tool_length tool_length line arc shift units",
    "spindle": "spindle spindle override tap tap change_tool line arc kept_modes feed_mode",
    "reference": "reference line shift set_system tool_length",
    "cycles": "cycle cycle tap choose_plane line units override",
    "contours": "contour line units spindle",
    "polar": "polar polar polar line distance units system set_system arc feed_mode",
    "programming": "variables loop loop line arc nested named_sub",
    "calls": "named_sub named_sub nested loop line units",
    "programs": "repeated_call repeated_call line units variables",
    "state": "told told kept_modes line units system shift distance feed_mode choose_plane",
    "splines": "spline spline line units shift",
    "all": "line arc arc_by_radius choose_plane units distance feed_mode path_control dwell spindle override system set_system "
           "shift change_tool tool_length reference cycle tap variables loop",
}


def write(seed, subject=None):
    program = Program(seed)
    subject = subject or program.rng.choice(list(SUBJECTS))
    statements = SUBJECTS[subject].split()
    if subject == "splines":
        program.tool_changes = False
    program.everywhere()
    for _ in range(program.rng.randint(3, 14)):
        getattr(program, program.rng.choice(statements))()
    return program


def valid(seed, subject=None):
    return write(seed, subject).text().encode()


# Ways to break a line

def drop_word(rng, words):
    words.pop(rng.randrange(len(words)))


def double_word(rng, words):
    words.insert(rng.randrange(len(words) + 1), rng.choice(words))


def foreign_word(rng, words):
    words.append(rng.choice(("Q1", "P2", "L3", "H1", "D1", "E2", "K1", "I1", "J1", "R5", "A1", "S5", "T3", "F0", "F-1",
                             "X", "Y1.2.3", "ZZ", "G", "M", "W", "#", "[1", "1]", "X[1/0]", "X#<unknown>", "(open")))


def foreign_code(rng, words):
    words.insert(0, rng.choice(("G0", "G1", "G2", "G3", "G17", "G18", "G43", "G92", "G53", "G80", "G81", "G4", "G90 G91",
                                "G20 G21", "M3 M5", "M3 M8", "G7.7", "G100", "M200", "G54 G55", "G1.5", "G-1", "M-2",
                                "G41", "G40", "G93", "M6", "M6 T2", "M49", "M51 P0", "M61 Q3", "G84", "G74", "M19",
                                "G61 G64", "G28", "G10 L2 P1", "G10 L2 P10", "G43 H77", "T-1",
                                "T1.5", "S-1", "G5 I1 J1", "G73", "G98 G99")))


def spoil_character(rng, words):
    index = rng.randrange(len(words))
    place = rng.randrange(len(words[index]) + 1)
    words[index] = words[index][:place] + rng.choice("?@!$&*+-.,:=_'\"xyzgmoi0#[](") + words[index][place:]


def spoil_number(rng, words):
    index = rng.randrange(len(words))
    letter = words[index][:1]
    words[index] = letter + rng.choice(("", "-", "+", ".", "--1", "1..2", "1e", "abc", "[2", "2]", "[1+]", "[*2]", "[1 2]",
                                        "[SIN 3]", "[SQRT[-1]]", "[LN[0]]", "#0", "#9999", "#-1", "#[1/0]", "[ACOS[2]]"))


def broken(seed, subject=None):
    program = write(seed, subject)
    rng = program.rng
    breaks = (drop_word, double_word, foreign_word, foreign_code, spoil_character, spoil_number)
    for _ in range(rng.choice((1, 1, 1, 2))):
        index = rng.randrange(len(program.lines))
        words = program.lines[index].split(" ")
        rng.choice(breaks)(rng, words)
        line = " ".join(words)
        if program.tool_changes or not CHANGE.search(line):
            program.lines[index] = line
    return program.text().encode()
