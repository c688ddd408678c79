// SPDX-License-Identifier: MIT
// The operator's console on a driven clock: what each key does, and that no other key moves
// anything.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "apps/shell.hpp"
#include "hal/machine/state_file.hpp"
#include "operate/console.hpp"
#include "support/property.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;
using runtime::MachineMode;

namespace {

constexpr double kDrivenPeriod = 0.001;  // s

bool shows(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

Options options_of(const std::string& machine, std::vector<std::string> settings = {}) {
  Options options;
  options.command = CommandName::operate;
  options.names_machine = true;
  options.machine_file = machine;
  options.settings = std::move(settings);
  return options;
}

/// A console on a clock that goes only where it is driven.
class Driven {
 public:
  explicit Driven(const Options& options) : machine(open(options)), console(*machine, journal) {}

  void press(const Key& key) {
    console.key(key, now);
    wait(0.02);
  }
  void type(const std::string& text) {
    for (const char c : text) press(c == '\n' ? Key{Key::Kind::enter} : key_of(c));
  }
  void wait(double seconds) {
    for (const double end = now + seconds; now < end; now += kDrivenPeriod)
      REQUIRE(console.advance(now).has_value());
  }
  /// Waits until the machine is in a mode, and rests.
  void wait_for(MachineMode mode, double most = 120) {
    for (double waited = 0; waited < most; waited += 0.01) {
      wait(0.01);
      if (control().mode() == mode && !control().in_motion()) return;
    }
    FAIL("not in that mode after " << most << " s:\n" << text());
  }
  std::string text(int rows = 24, int columns = 80) const {
    Screen screen(rows, columns);
    console.draw(screen);
    return screen.text();
  }
  runtime::Operator& control() { return machine->control(); }
  AxisVector place() { return control().position(); }

  Journal journal;
  double now = 0;  // s
  std::unique_ptr<AttendedMachine> machine;
  Console console;

 private:
  std::unique_ptr<AttendedMachine> open(const Options& options) {
    Messages messages([](std::string_view) {}, false);
    auto opened = AttendedMachine::open(options, messages, [this](const Diagnostic& found) {
      journal.add(found, machine != nullptr && control().in_program());
    });
    REQUIRE(opened.has_value());
    return std::move(*opened);
  }
};

constexpr Key kRight{Key::Kind::right}, kLeft{Key::Kind::left}, kUp{Key::Kind::up},
    kPageUp{Key::Kind::page_up}, kEnter{Key::Kind::enter}, kEscape{Key::Kind::escape},
    kControlC{Key::Kind::interrupt};

const std::string kFirstPart = SOFTCNC_SOURCE_DIR "/programs/31_first_part.nc";
const std::string kFirstMachine = SOFTCNC_SOURCE_DIR "/programs/31_first_part.toml";

}  // namespace

TEST_CASE("a jog key: a press is a step, a held one goes on, and late ones are not made up for",
          "[apps][operate]") {
  using Act = JogKeys::Act;
  constexpr auto kKey = Key::Kind::right, kOther = Key::Kind::left;
  SECTION("presses") {
    JogKeys keys;
    CHECK(keys.press(kKey, 0) == Act::step);
    CHECK(keys.press(kKey, 0.3) == Act::step);
    CHECK(keys.press(kKey, 0.6) == Act::step);
    CHECK(keys.press(kOther, 0.9) == Act::step);
    CHECK(keys.press(kKey, 5) == Act::step);
  }
  SECTION("held") {
    JogKeys keys;
    CHECK(keys.press(kKey, 0) == Act::step);
    CHECK(keys.press(kKey, 0.5) == Act::step);
    CHECK(keys.press(kKey, 0.53) == Act::begin);
    CHECK(keys.press(kKey, 0.56) == Act::nothing);
    CHECK(keys.wait(0.6) == Act::nothing);
    CHECK(keys.wait(0.56 + 0.15) == Act::stop);
    CHECK(keys.wait(1) == Act::nothing);
  }
  SECTION("another key ends it, and does nothing else") {
    JogKeys keys;
    keys.press(kKey, 0);
    keys.press(kKey, 0.5);
    CHECK(keys.press(kKey, 0.53) == Act::begin);
    CHECK(keys.press(kOther, 0.55) == Act::stop);
    CHECK(keys.press(kOther, 2) == Act::step);
    CHECK(keys.release() == Act::nothing);
  }
  SECTION("twenty at once are one") {
    JogKeys keys;
    CHECK(keys.press(kKey, 1) == Act::step);
    for (int i = 0; i < 20; ++i) CHECK(keys.press(kKey, 1) == Act::nothing);
    CHECK_FALSE(keys.is_continuous());
  }
}

TEST_CASE("a line is edited, and those before come back", "[apps][operate]") {
  LineEditor editor;
  const auto type = [&](const std::string& text) {
    for (const char c : text) editor.key(key_of(c));
  };
  type("G1 X1");
  CHECK(editor.take() == "G1 X1");
  type("G2");
  editor.key({Key::Kind::left});
  editor.key({Key::Kind::backspace});
  editor.key({Key::Kind::delete_});
  type("G0 Y");
  editor.key({Key::Kind::home});
  type("/");
  CHECK(editor.text() == "/G0 Y");
  editor.key(kUp);
  CHECK(editor.text() == "G1 X1");
  editor.key(kUp);
  editor.key({Key::Kind::down});
  CHECK(editor.text() == "/G0 Y");
  editor.clear();
  editor.key(kUp);
  CHECK(editor.take() == "G1 X1");
}

TEST_CASE("from an unknown position to a part, by keys alone", "[apps][operate]") {
  Driven desk(options_of(kFirstMachine));
  CHECK(shows(desk.text(), "the position is not known: h homes"));
  desk.console.load(kFirstPart);
  desk.type("s");
  CHECK(shows(desk.text(), "the position of the machine is not known [SC5070]"));
  desk.type("h");
  CHECK(desk.control().mode() == MachineMode::home);
  desk.wait_for(MachineMode::idle);
  CHECK(desk.control().knows_position());
  CHECK((desk.place() - AxisVector(-150, -100, 60)).cwiseAbs().maxCoeff() < 0.01);

  desk.type("mG53 G00 X20 Y30\n");
  desk.wait_for(MachineMode::idle);
  desk.press(kEscape);
  desk.type("pZ-105=0\n");
  desk.wait_for(MachineMode::idle, 300);
  // The tip has met the upper side of the block at Z -40, and is back where it began.
  CHECK(desk.control().state().work_system(0).origin[2] == Approx(-40).margin(0.003));
  CHECK(desk.place()[2] == Approx(60).margin(0.01));
  desk.type("mG53 G00 X0 Y30\nG53 G00 Z-45\n");
  desk.wait_for(MachineMode::idle);
  desk.press(kEscape);
  desk.type("pX15=-2\n");  // the radius of its ball before the side at X10
  desk.wait_for(MachineMode::idle);
  CHECK(desk.control().state().work_system(0).origin[0] == Approx(10).margin(0.003));
  desk.type("pX4=0\n");
  desk.wait_for(MachineMode::idle);
  CHECK(shows(desk.text(), "G38.2 comes to its end without a contact [SC2394]"));
  CHECK(desk.control().state().work_system(0).origin[0] == Approx(10).margin(0.003));
  desk.type("w");
  CHECK(shows(desk.text(), "* G54"));
  desk.press(kEnter);
  desk.type("Y10\n");  // measured before
  desk.wait_for(MachineMode::idle);
  desk.type("qo");
  CHECK(shows(desk.text(), "T1 end mill 6 mm"));
  desk.press(kEnter);
  desk.type("Z20 R3\n");
  desk.wait_for(MachineMode::idle);
  desk.press({Key::Kind::down});
  desk.press(kEnter);
  desk.type("Z25 R3\n");
  desk.wait_for(MachineMode::idle);
  desk.type("qmG53 G00 Z60\n");
  desk.wait_for(MachineMode::idle);
  desk.press(kEscape);

  desk.type("s");
  desk.wait_for(MachineMode::hold);
  CHECK(shows(desk.text(), "T1 end mill 6 mm in, then Enter"));
  CHECK((desk.place() - AxisVector(0, -80, 60)).norm() < 1e-9);
  CHECK(desk.control().outputs() == Outputs{});
  desk.press(kEnter);
  desk.wait_for(MachineMode::hold);
  CHECK(shows(desk.text(), "T2 ball nose 6 mm in, then Enter"));
  CHECK(desk.control().outputs() == Outputs{});
  desk.press(kEnter);
  desk.wait_for(MachineMode::idle);
  CHECK(shows(desk.text(), "the program has ended"));
  CHECK(desk.control().state().loaded_tool == 2);
}

TEST_CASE("after a change of the tool coolant comes back, and the way leads over the part",
          "[apps][operate]") {
  const Folder folder;
  write(folder / "p.nc", "G90 G21 M03 S6000 M08\nG01 X5 F600\nT1 M06\nX10\nM30\n");
  Driven desk(options_of(kFirstMachine, {"tool_change.at=[20, -80, 30]"}));
  desk.console.load(folder / "p.nc");
  desk.type("kX0 Y0 Z0\n");
  desk.type("s");
  desk.wait_for(MachineMode::hold);
  CHECK((desk.place() - AxisVector(20, -80, 30)).norm() < 1e-9);
  CHECK(desk.control().outputs() == Outputs{});
  desk.press(kEnter);
  CHECK(desk.control().outputs().flood);
  CHECK(desk.control().outputs().spindle_rpm == 0);  // M06 stops it
  while (desk.place()[2] > 29.999 && desk.now < 60) desk.wait(0.001);
  CHECK((desk.place() - AxisVector(5, 0, 30)).norm() < 0.01);
  desk.wait_for(MachineMode::idle);
  CHECK(desk.place()[0] == 10);
}

TEST_CASE("jog keys move by steps, and on while one is held", "[apps][operate]") {
  Driven desk(options_of(""));
  desk.press(kRight);
  desk.wait_for(MachineMode::idle);
  CHECK(desk.place()[0] == Approx(1).margin(1e-9));
  desk.type(",");
  desk.press(kUp);
  desk.press(kPageUp);
  desk.wait_for(MachineMode::idle);
  CHECK(desk.place()[1] == Approx(0.1).margin(1e-9));
  CHECK(desk.place()[2] == Approx(0.1).margin(1e-9));

  desk.wait(1);
  desk.press(kRight);
  desk.wait(0.48);
  for (int i = 0; i < 40; ++i) {  // held for 1.2 s more
    desk.press(kRight);
    desk.wait(0.01);
  }
  const double released = desk.now;
  CHECK(desk.control().mode() == MachineMode::jog);
  CHECK(desk.place()[0] > 15);
  desk.wait(0.15);
  const double braking = desk.control().last().v / 1000 + 0.005;  // s: at 1000 mm/s^2
  desk.wait(braking);
  CHECK_FALSE(desk.control().moving());
  CHECK(desk.now - released < 0.5);

  desk.type("mG01 X0 F600\n");
  desk.wait_for(MachineMode::idle);
  desk.press(kRight);  // the prompt is open: no jog
  desk.press(kPageUp);
  CHECK(desk.control().mode() == MachineMode::idle);
}

TEST_CASE("Ctrl-C holds whatever is shown, and Enter goes on", "[apps][operate]") {
  Driven desk(options_of(""));
  desk.type("mG91 G01 X50 F3000\n");
  desk.wait(0.3);
  desk.press(kControlC);
  desk.wait_for(MachineMode::hold);
  CHECK(desk.place()[0] < 50);
  desk.press(kEscape);
  desk.press(kPageUp);
  desk.wait(1);
  CHECK(desk.place()[2] == Approx(1).margin(1e-9));
  CHECK(shows(desk.text(), "Enter goes back and on"));
  desk.press(kEnter);
  desk.wait_for(MachineMode::idle);
  CHECK((desk.place() - AxisVector(50, 0, 0)).norm() < 1e-9);
}

TEST_CASE("a bore, a boss and a corner are probed by one line each", "[apps][operate]") {
  const Folder folder;
  const std::string bodies =
      "[contact.left]\nmin_mm = [-60, 15, -60]\nmax_mm = [-47.5, 90, -20]\n"
      "[contact.right]\nmin_mm = [-12.5, 15, -60]\nmax_mm = [0, 90, -20]\n"
      "[contact.front]\nmin_mm = [-60, 15, -60]\nmax_mm = [0, 30, -20]\n"
      "[contact.back]\nmin_mm = [-60, 72.25, -60]\nmax_mm = [0, 90, -20]\n";
  write(folder / "mill.toml", read(kFirstMachine) + bodies);
  Driven desk(options_of(folder / "mill.toml"));
  desk.type("kX0 Y0 Z0\n");
  const auto go = [&](const std::string& lines) {
    desk.type("m" + lines + "\n");
    desk.wait_for(MachineMode::idle);
    desk.press(kEscape);
  };
  const auto probe = [&](const std::string& text) {
    go("G20 G91");
    desk.type("p" + text + "\n");
    desk.wait_for(MachineMode::idle, 300);
    CAPTURE(desk.text());
    CHECK_FALSE(shows(desk.text(), "SC2"));
    return AxisVector(desk.control().state().work_system(0).origin);
  };
  SECTION("a bore") {
    go("G90 G53 G00 X-33 Y50");
    go("G53 G00 Z-30");
    const AxisVector origin = probe("bore X36 Y42");
    CHECK((origin.head<2>() - Eigen::Vector2d(-30, 51.125)).norm() < 0.005);
    CHECK((desk.place().head<2>() - origin.head<2>()).norm() < 0.005);
  }
  SECTION("a boss") {
    go("G90 G53 G00 X41 Y28");
    go("G53 G00 Z-35");
    const AxisVector origin = probe("boss X60 Y40 Z8");
    CHECK((origin.head<2>() - Eigen::Vector2d(40, 30)).norm() < 0.005);
    CHECK(desk.place()[2] == Approx(-35).margin(0.003));
  }
  SECTION("a corner") {
    go("G90 G53 G00 X75 Y0");
    go("G53 G00 Z-45");
    const AxisVector origin = probe("corner X-12 Y15");
    CHECK((origin.head<2>() - Eigen::Vector2d(70, 10)).norm() < 0.005);
    CHECK((desk.place() - AxisVector(75, 0, -45)).norm() < 0.005);
  }
  SECTION("one that is not there") {
    go("G90 G53 G00 X75 Y-20");
    go("G20 G91");
    desk.type("pbore X10 Y10\n");
    desk.wait_for(MachineMode::idle);
    CHECK(shows(desk.text(), "[SC2394]"));
    go("G00 X1");
    CHECK(desk.place()[0] == Approx(75 - 11 + 25.4).margin(0.01));  // inches, and G91, again
  }
}

TEST_CASE("what is wrong with a line, a place or a program is shown", "[apps][operate]") {
  const Folder folder;
  write(folder / "wrong.nc", "G01 X1 F100\nX2000\nM30\n");
  Driven desk(options_of(""));
  desk.type("mG01 X5\n");
  desk.wait(0.1);
  CHECK(shows(desk.text(), "[SC"));
  desk.press(kEscape);
  desk.type("tX=3\n");
  CHECK(shows(desk.text(), "'X=3' is not an axis in mm, as X-12.5"));
  desk.type("pX5 Y5\n");
  CHECK(shows(desk.text(), "as Z-20, Z-20=0, bore X30 Y30, boss X60 Y40 Z8 or corner X15 Y15"));
  for (const char* wrong : {"bore", "bore X-3 Y3", "bore X3", "boss X30 Y30", "boss X3 Y3 Zx",
                            "corner X5", "corner X5 Z5", "corner X0 Y5", "pocket 3"}) {
    CAPTURE(wrong);
    desk.type(std::string("p") + wrong + "\n");
    CHECK(shows(desk.text(), " in mm"));
    CHECK(desk.control().mode() == MachineMode::idle);
  }
  desk.type("s");
  CHECK(shows(desk.text(), "no program is loaded: l loads one"));
  desk.type("l" + (folder / "missing.nc") + "\n");
  CHECK(shows(desk.text(), "missing.nc: "));
  desk.type("l" + (folder / "wrong.nc") + "\n");
  CHECK(shows(desk.text(), "1 error: v shows what the check has found"));
  desk.type("s");
  CHECK(desk.control().mode() == MachineMode::idle);
  desk.type("v");
  CHECK(shows(desk.text(), "wrong.nc:2:1: error: X reaches 2000 mm"));
}

TEST_CASE("where nobody is any more, the machine rests and the spindle goes off",
          "[apps][operate]") {
  const Folder folder;
  Options options = options_of("", {"operate.alone_s=2"});
  options.state = folder / "state.toml";
  Driven desk(options);
  desk.type("mM03 S3000\nG91 G01 X100 F3000\n");
  desk.wait(0.5);
  desk.console.leave_alone(false);
  desk.wait_for(MachineMode::hold);
  CHECK(desk.control().outputs().spindle_rpm == 3000);
  CHECK_FALSE(desk.console.is_over());
  desk.wait(2.1);
  CHECK(desk.console.is_over());
  CHECK(desk.control().outputs() == Outputs{});
  CHECK(desk.machine->finish().has_value());
  CHECK(shows(read(folder / "state.toml"), "in_motion = \"no\""));
}

TEST_CASE("the state file has the mark while the machine moves, and the place once it rests",
          "[apps][operate]") {
  const Folder folder;
  Options options = options_of("");
  options.state = folder / "state.toml";
  Driven desk(options);
  desk.type("mG91 G01 X10 F600\n");
  desk.wait(0.3);
  CHECK(shows(read(folder / "state.toml"), "in_motion = \"yes\""));
  desk.wait_for(MachineMode::idle);
  CHECK(shows(read(folder / "state.toml"), "x_mm = 10\n"));
  desk.press(kEscape);
  desk.type("kX-5\n");
  desk.wait(0.01);
  CHECK(shows(read(folder / "state.toml"), "x_mm = -5\n"));
  desk.type("tX0\n");
  desk.wait_for(MachineMode::idle);
  CHECK(shows(read(folder / "state.toml"), "[work.\"G54\"]\nx_mm = -5\n"));
}

TEST_CASE("the page of keys shows each with all of its help", "[apps][operate]") {
  constexpr std::size_t kRoom = 30;
  Driven desk(options_of(""));
  desk.type("?");
  for (const Console::Binding& binding : Console::bindings()) {
    CHECK(binding.help.size() <= kRoom);
    CHECK(shows(desk.text(), std::string(binding.help)));
  }
}

TEST_CASE("a screen of any size is drawn", "[apps][operate]") {
  Driven desk(options_of(kFirstMachine));
  desk.console.load(kFirstPart);
  for (const char* page : {"", "?", "w", "o", "v", "m"}) {
    desk.type(page);
    for (const auto& [rows, columns] :
         {std::pair{5, 20}, {24, 80}, {100, 300}, {1, 1}, {2, 10}, {0, 0}, {12, 40}}) {
      const std::string text = desk.text(rows, columns);
      CHECK(std::count(text.begin(), text.end(), '\n') == rows);
    }
    desk.press(kEscape);
  }
  const std::string small = desk.text(5, 20);
  CHECK(shows(small, " X        0.000"));
  CHECK(shows(small, " Z        0.000"));
}

TEST_CASE("whatever is typed, limits hold in every period, and only jog keys jog",
          "[apps][operate][property]") {
  const char* asked = std::getenv("SOFTCNC_KEYS");
  const int presses = asked != nullptr ? std::atoi(asked) : 2000;
  const std::vector<std::string> lines{"mG91 G01 X3 F3000\n",
                                       "mG02 X2 Y2 I2 F2000\n",
                                       "mM03 S500\n",
                                       "mG00 Z-1\n",
                                       "s",
                                       "h",
                                       "tX0\n",
                                       "kX0 Y0 Z0\n"};
  const bool moves = GENERATE(false, true);
  std::mt19937 engine(7);
  const auto below = [&](unsigned end) { return static_cast<unsigned>(engine() % end); };
  Driven desk(options_of(kFirstMachine));
  desk.console.load(kFirstPart);
  AxisVector last = desk.place(), speed = AxisVector::Zero();
  int known = 0;  // periods that have followed each other
  const auto watch = [&](double seconds) {
    if (desk.place() != last) known = 0;  // somebody has said where the machine stands
    last = desk.place();
    for (const double end = desk.now + seconds; desk.now < end; desk.now += kDrivenPeriod) {
      const bool was_known = desk.control().knows_position();
      const auto period = desk.control().last().period;
      REQUIRE(desk.console.advance(desk.now).has_value());
      const AxisVector now = (desk.place() - last) / kDrivenPeriod;
      const bool breaks = desk.control().mode() == MachineMode::alarm ||
                          desk.control().pause() != nullptr ||  // its place is no row
                          desk.control().last().period > period + 1 ||
                          desk.control().knows_position() != was_known || now.norm() > 1000;
      known = breaks ? 0 : known + 1;
      if (known > 2) {
        INFO(now.transpose() << " after " << speed.transpose() << ", " << known << " rows");
        INFO("at " << desk.now << " s:\n" << desk.text());
        for (int axis = 0; axis < kAxes; ++axis) {
          REQUIRE(std::abs(now[axis]) <= 250 * 1.001);
          REQUIRE(std::abs(now[axis] - speed[axis]) <= 1000 * kDrivenPeriod * 1.001 + 1e-9);
        }
      }
      last = desk.place();
      speed = now;
    }
  };
  for (int i = 0; i < presses && !desk.console.is_over(); ++i) {
    const unsigned kind = below(10);
    if (moves && kind == 0) {
      for (const char c : lines[below(static_cast<unsigned>(lines.size()))])
        desk.console.key(c == '\n' ? kEnter : key_of(c), desk.now);
      desk.console.key(kEscape, desk.now);
    } else if (moves && kind < 4) {
      const Key jogs[] = {kLeft, kRight, kUp, kPageUp};
      desk.console.key(jogs[below(4)], desk.now);
    } else {
      char c = static_cast<char>(' ' + static_cast<char>(below(95)));
      const bool leads_on = c == 'q' || (!moves && (c == 'h' || c == 'k'));
      if (leads_on) c = '~';
      const Key others[] = {key_of(c), key_of(c), key_of(c), kEscape, kControlC, Key{}, kEnter};
      desk.console.key(others[below(7)], desk.now);
    }
    watch(below(4) == 0 ? 0.001 * below(400) : 0.001 * below(20));
    if (!moves) REQUIRE(desk.place() == AxisVector::Zero());
  }
  // It can still be brought to rest.
  desk.console.key(kControlC, desk.now);
  watch(5);
  CHECK_FALSE(desk.control().moving());
}

TEST_CASE("without a terminal, or with one that is not known, nothing begins", "[apps][operate]") {
  const Ended piped = call("operate < /dev/null");
  CHECK(piped.status == 5);
  CHECK(piped.err ==
        "softcnc: error: standard input and output are not both a terminal [SC6018]\n");
  const Ended unknown = on_terminal(std::string("TERM=nonsense ") + SOFTCNC_BINARY + " operate");
  CHECK(unknown.status == 5);
  CHECK(shows(unknown.out, "the terminal is not known by its name in TERM"));
}
