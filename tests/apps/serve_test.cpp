// SPDX-License-Identifier: MIT
// grbl's protocol on a driven clock: what is sent, what comes back, and what the machine does.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "apps/shell.hpp"
#include "serve/clients.hpp"
#include "serve/grbl_control.hpp"
#include "serve/grbl_numbers.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;
using runtime::MachineMode;

namespace {

constexpr double kServedPeriod = 0.001;  // s

Options served_options(const std::string& machine, std::vector<std::string> settings) {
  Options options;
  options.command = CommandName::serve;
  options.names_machine = true;
  options.machine_file = machine;
  options.settings = std::move(settings);
  options.dialect = ipr::Dialect::grbl;
  return options;
}

/// A sender and its machine, on a clock that goes only where it is driven.
class Served {
 public:
  explicit Served(std::vector<std::string> settings = {}, const std::string& machine_file = {},
                  const std::string& trace = {}) {
    Options options = served_options(machine_file, std::move(settings));
    options.trace = trace;
    Messages messages([](std::string_view) {}, false);
    auto opened = AttendedMachine::open(options, messages,
                                        [this](const Diagnostic& found) { control->hear(found); });
    REQUIRE(opened.has_value());
    machine = std::move(*opened);
    control.emplace(*machine, journal);
    control->take_output();
  }

  /// Sends bytes, and returns what has come back after so many seconds.
  std::string say(const std::string& bytes, double seconds = 0.02) {
    control->take(bytes, now);
    std::string heard = control->take_output();
    for (const double end = now + seconds; now < end; now += kServedPeriod) {
      REQUIRE(control->advance(now).has_value());
      heard += control->take_output();
    }
    return heard;
  }
  std::string wait(double seconds) { return say("", seconds); }
  /// Returns the report of now.
  std::string report() { return say("?", 0); }
  AxisVector place() const { return machine->control().position(); }

  Journal journal;
  double now = 0;  // s
  std::unique_ptr<AttendedMachine> machine;
  std::optional<GrblControl> control;
};

bool begins(const std::string& text, const std::string& part) { return text.rfind(part, 0) == 0; }

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++count;
  return count;
}

std::string chords(int count) {
  std::string text = "G21 G90 G1 F15000\n";
  for (int i = 1; i <= count; ++i) {
    const double s = 0.1 * i;
    text += "X" + std::to_string(s) + " Y" + std::to_string(5 * std::sin(s / 20)) + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("what is sent to grbl gets grbl's answers", "[apps][serve]") {
  struct Line {
    std::string sent, heard, state;
    double seconds = 0.02;
  };
  const std::vector<Line> dialogue{
      {"\n", "ok\r\n", "Idle"},
      {"%\n(nothing) \n;nor here\n", "ok\r\nok\r\nok\r\n", "Idle"},
      {"G21 G90\r\n", "ok\r\nok\r\n", "Idle"},  // two line ends
      {"G1 X1 F600\n", "ok\r\n", "Run"},
      {"", "", "Idle", 1},
      {"G4 P0.2\n", "", "Run"},
      {"", "ok\r\n", "Idle", 0.5},
      {"M3 S1000\n", "ok\r\n", "Idle", 0.1},
      {"$G\n", "[GC:G1 G54 G17 G21 G90 G94 M3 M9 T0 F600 S1000]\r\nok\r\n", "Idle"},
      {"\xa0", "", "Idle"},
      {"$G\n", "[GC:G1 G54 G17 G21 G90 G94 M3 M8 T0 F600 S1000]\r\nok\r\n", "Idle"},
      {"\xa1\xa0", "", "Idle"},
      {"$G\n", "[GC:G1 G54 G17 G21 G90 G94 M3 M7 T0 F600 S1000]\r\nok\r\n", "Idle"},
      {"\xa1", "", "Idle"},
      {"$I\n", "[VER:1.1h.20190830:softcnc (Grbl 1.1)]\r\n[OPT:VNMZ,15,65535]\r\nok\r\n", "Idle"},
      {"$N\n", "$N0=\r\n$N1=\r\nok\r\n", "Idle"},
      {"g7 7\n", "[MSG:SC2001 G77 is not supported]\r\nerror:20\r\n", "Idle"},
      {"G1 X\n", "[MSG:SC1002 no number after X]\r\nerror:2\r\n", "Idle"},
      {"$bogus\n", "error:3\r\n", "Idle"},
      {"$100=400\n$100=401\n", "ok\r\n[MSG:$100 is what the machine file says]\r\nerror:3\r\n",
       "Idle"},
      {"$H\n", "error:5\r\n", "Idle"},
      {"$J=G91 X2 F600\n", "ok\r\n", "Jog"},
      {"G1 X5\n", "error:9\r\n", "Jog"},
      {"\x85", "", "Idle", 0.2},
      {"$J=G91 X2\n", "[MSG:a jog needs a feed: F, above 0]\r\nerror:22\r\n", "Idle"},
      {"$J=G91 F100\n$J=G91 X1 F100 S5\n",
       "[MSG:a jog takes X Y Z, F, G20, G21, G53, G90 and G91]\r\nerror:16\r\n[MSG:a jog takes X Y "
       "Z, F, G20, G21, G53, G90 and G91]\r\nerror:16\r\n",
       "Idle"},
      {"$J=G53 X5000 F100\n",
       "[MSG:SC4001 a jog to X5000 leaves the travel X-1000 to X1000]\r\nerror:15\r\n", "Idle"},
      {"G1 X50 F600\n$J=G91 X1 F100\n", "ok\r\nerror:8\r\n", "Run"},
      {"!", "", "Hold:0", 0.3},
      {"G1 X0\n$G\n", "", "Hold:0"},  // nothing is read in hold
      {"~", "", "Run", 0.001},
      {"\x18", "", "Alarm", 0.3},
      {"G1 X0\n$X\n", "error:9\r\n[MSG:Caution: Unlocked]\r\nok\r\n", "Idle"},
      {"!", "", "Hold:0"},  // also where nothing moves
      {"~", "", "Idle"},
      {"$C\nG1 X900\n$C\n", "[MSG:Enabled]\r\nok\r\nok\r\n[MSG:Disabled]\r\nok\r\n", "Idle"},
      {"M2\nG4 P0\n", "[MSG:Pgm End]\r\nok\r\nok\r\n", "Idle", 0.1},
      {"o1 repeat [2]\nG91 G1 X1 F6000\no1 endrepeat\n", "ok\r\nok\r\nok\r\n", "Run"},
      {"", "", "Idle", 1},
      {"$SLP\n", "[MSG:Sleeping]\r\nok\r\n", "Sleep"},
      {"\x18", "\r\nGrbl 1.1h ['$' for help]\r\n", "Alarm"},
  };
  Served served;
  for (const Line& line : dialogue) {
    INFO("sent: " << line.sent);
    const std::string heard = served.say(line.sent, line.seconds);
    const bool is_dense = line.heard.empty() || heard.find("Grbl") != std::string::npos;
    if (line.sent != "\x18" && line.sent != "~" && !is_dense) CHECK(heard == line.heard);
    if (line.sent == "\x18") CHECK(heard.find("Grbl 1.1h") != std::string::npos);
    CHECK(begins(served.report(), "<" + line.state + "|"));
  }
}

TEST_CASE("work offsets and overrides are reported as seldom as grbl reports them",
          "[apps][serve]") {
  Served served;
  CHECK(served.report() ==
        "<Idle|MPos:0.000,0.000,0.000|Bf:15,65535|FS:0,0|WCO:0.000,0.000,0.000>"
        "\r\n");
  CHECK(served.report() == "<Idle|MPos:0.000,0.000,0.000|Bf:15,65535|FS:0,0|Ov:100,100,100>\r\n");
  int offsets = 0, overrides = 0;
  for (int i = 0; i < 40; ++i) {
    const std::string report = served.report();
    offsets += count_of(report, "WCO:");
    overrides += count_of(report, "Ov:");
    CHECK(count_of(report, "WCO:") + count_of(report, "Ov:") <= 1);
  }
  CHECK(offsets == 4);
  CHECK(overrides == 4);
  served.say("G92 X5\n", 0.1);
  CHECK(count_of(served.report(), "WCO:-5.000,0.000,0.000") == 1);
  served.say("\x91");
  CHECK(count_of(served.report(), "Ov:110,100,100") == 1);
  served.say("$13=1\n");
  CHECK(begins(served.report(), "<Idle|MPos:0.0000,0.0000,0.0000|"));
  CHECK(served.say("???", 0) == served.say("", 0) + served.say("", 0) +
                                    "<Idle|MPos:0.0000,0.0000,0.0000|Bf:15,65535|FS:0,0>\r\n");
}

TEST_CASE("a reset keeps offsets, loses G92, and is an alarm only from motion", "[apps][serve]") {
  Served served;
  served.say("G10 L2 P1 X7\nG92 Y3\n", 0.2);
  CHECK(served.say("\x18") == "\r\nGrbl 1.1h ['$' for help]\r\n");
  CHECK(count_of(served.report(), "WCO:7.000,0.000,0.000") == 1);
  served.say("G1 X20 F1000\n", 0.2);
  CHECK(served.say("\x18", 0.3) ==
        "ALARM:3\r\n\r\nGrbl 1.1h ['$' for help]\r\n[MSG:'$H'|'$X' to unlock]\r\n");
  CHECK(served.machine->control().knows_position());  // it has braked on the path
  CHECK(served.say("$X\n") == "[MSG:Caution: Unlocked]\r\nok\r\n");
  served.say("G1 X-50 F1000\n", 0.3);
  served.say("!", 0.3);
  CHECK(served.say("\x18") == "\r\nGrbl 1.1h ['$' for help]\r\n");  // from Hold:0 none
  CHECK(begins(served.report(), "<Idle|"));
}

TEST_CASE("an unknown place is an alarm until somebody has homed, or said where it is",
          "[apps][serve]") {
  Served served({}, SOFTCNC_SOURCE_DIR "/programs/31_first_part.toml");
  CHECK(begins(served.report(), "<Alarm|"));
  CHECK(served.say("G1 X1 F100\n") == "error:9\r\n");
  CHECK(served.say("$H\n").empty());
  CHECK(begins(served.report(), "<Home|"));
  CHECK(served.wait(60) == "ok\r\n");
  CHECK(begins(served.report(), "<Idle|MPos:-150.00"));
}

TEST_CASE("a probe reports its contact in machine coordinates", "[apps][serve]") {
  Served served({"contact.block.min_mm=[-10,-10,-20]", "contact.block.max_mm=[10,10,-5]"});
  CHECK(served.say("G21 G91 G38.2 Z-9 F100\n", 10) == "[PRB:0.000,0.000,-5.000:1]\r\nok\r\n");
  served.say("G90 G0 Z0\n", 1);
  CHECK(count_of(served.say("$#\n"), "[PRB:0.000,0.000,-5.000:1]") == 1);
  const std::string missed = served.say("G38.2 Z-3 F100\n", 10);
  CHECK(count_of(missed, "ALARM:5") == 1);
  CHECK(count_of(missed, "SC2394") == 1);
  CHECK(count_of(missed, "[PRB:") == 1);
  CHECK(count_of(missed, "[PRB:0.000,0.000,0.000:0]") == 1);
  CHECK(begins(served.report(), "<Alarm|"));
  CHECK(served.place()[2] == Approx(-3));  // it has looked
}

TEST_CASE("a jog stops in time, and drops those that were sent before it", "[apps][serve]") {
  Served served;
  std::string jogs;
  for (int i = 0; i < 50; ++i) jogs += "$J=G91 X1 F3000\n";
  CHECK(count_of(served.say(jogs, 0.3), "ok") == 50);
  CHECK(begins(served.report(), "<Jog|"));
  served.say("\x85", 0.1);
  CHECK(begins(served.report(), "<Idle|"));
  CHECK(served.place()[0] < 20);
  served.say("$J=G90 X2 Y2 F3000\n", 2);
  CHECK((served.place() - AxisVector(2, 2, 0)).norm() < 1e-6);
  served.say("G92 X0\n", 0.1);
  served.say("$J=G53 X5 F3000\n", 2);
  served.say("$J=G20 G91 Y1 F100\n", 5);
  CHECK((served.place() - AxisVector(5, 27.4, 0)).norm() < 1e-6);
}

TEST_CASE("a cancel drops the jogs that were sent before it, wherever the machine is",
          "[apps][serve]") {
  Served served;
  CHECK(served.say("$J=G91 X50 F3000\n\x85", 0.5) == "ok\r\n");
  CHECK(served.place()[0] < 1);
  const double before = served.place()[0];
  CHECK(served.say("G4 P0.2\n$J=G91 X5 F3000\n\x85", 1) == "ok\r\nok\r\n");
  CHECK(served.place()[0] == before);
  served.say("!", 0.1);
  served.say("$J=G91 X5 F3000\n\x85~", 1);
  CHECK(served.place()[0] == before);
  CHECK(served.say("G90\n$J=G91 X1 F3000\n", 1) == "ok\r\nok\r\n");  // no moment of Run between
  CHECK(served.place()[0] == Approx(before + 1));
  CHECK(served.say("$J=G91 X1,5 F100\n$J=G91 X1 X2 F100\n$J=G91 X Y F100\n") ==
        "[MSG:a jog has a word without a number]\r\nerror:2\r\n"
        "[MSG:a jog has a word twice]\r\nerror:25\r\n"
        "[MSG:a jog has a word without a number]\r\nerror:2\r\n");
}

TEST_CASE("a loop without an end is held, and left by a reset", "[apps][serve]") {
  Served served;
  const std::string loop = "o100 while [1]\nG91 G1 X0.1 F600\nG1 X-0.1\no100 endwhile\n";
  CHECK(count_of(served.say(loop, 1), "ok") == 4);
  CHECK(begins(served.report(), "<Run|"));
  served.say("!", 0.3);
  CHECK(begins(served.report(), "<Hold:0|"));
  served.say("\x18", 0.2);
  CHECK(begins(served.report(), "<Idle|"));
}

TEST_CASE("homing that is broken off leaves the machine locked, and a hold stops the way to a tool",
          "[apps][serve]") {
  Served served({}, SOFTCNC_SOURCE_DIR "/programs/31_first_part.toml");
  served.say("$H\n", 0.3);
  served.say("\x84", 0.5);
  served.say("~", 0.2);
  CHECK(begins(served.report(), "<Alarm|"));
  CHECK(served.say("$H\n", 60) == "ok\r\n");
  served.say("G53 G0 X100 Y80 Z-20\n", 10);
  served.say("T1 M6\n", 0.4);
  served.say("!", 0.5);
  const AxisVector held = served.place();
  served.wait(1);
  CHECK(served.place() == held);
  CHECK((held - AxisVector(0, -80, 60)).norm() > 1);
  served.say("~", 10);
  CHECK((served.place() - AxisVector(0, -80, 60)).norm() < 1e-6);
  CHECK(served.say("~", 10) == "ok\r\n");
  CHECK((served.place() - AxisVector(100, 80, -20)).norm() < 1e-6);
}

TEST_CASE("a client that has gone leaves nothing behind that moves", "[apps][serve]") {
  Served served({"operate.alone_s=1"});
  served.say("M3 S500\no1 repeat [3]\nG91 G1 X500 F3000\n", 0.2);
  served.control->leave_alone();
  served.control->come_back();
  CHECK(served.say("G91 G1 Y1 F3000\n", 1) == "ok\r\n");
  CHECK((served.place() - AxisVector(0, 1, 0)).norm() < 1e-6);
  served.say("G1 X50 F3000\n", 0.3);
  served.control->leave_alone();
  served.wait(0.5);
  CHECK(begins(served.report(), "<Hold:0|"));
  CHECK(served.machine->control().outputs().spindle_rpm == 500);
  served.wait(1);
  CHECK(served.machine->control().outputs() == Outputs{});
}

TEST_CASE("after a program modes are grbl's, and the contact stays where it was", "[apps][serve]") {
  Served served({"contact.block.min_mm=[-10,-10,-20]", "contact.block.max_mm=[10,10,-5]"});
  served.say("G55 G91 G18 M3 S1000 M8\n\x91M30\n", 0.3);
  CHECK(count_of(served.say("$G\n"), " G54 G17 G21 G90 G94 M5 M9 ") == 1);
  CHECK(count_of(served.report(), "Ov:110") == 0);
  served.say("G38.2 Z-9 F100\n", 10);
  served.say("G10 L20 P1 Z0\nG20\n", 0.1);
  CHECK(count_of(served.say("$#\n"), "[PRB:0.000,0.000,-5.000:1]") == 1);
}

TEST_CASE("streamed chords are the rows that run makes of their file", "[apps][serve]") {
  const bool counts = GENERATE(false, true);  // characters, or waits for each answer
  constexpr int kChords = 2000;
  constexpr std::size_t kBuffer = 1000;  // bytes that a sender has under way
  const Folder folder;
  write(folder / "p.nc", chords(kChords) + "G4 P0\n");
  const Ended run =
      call("run -q " + (folder / "p.nc") + " --dialect grbl --trace " + (folder / "run.csv"));
  REQUIRE(run.status == 0);
  {
    Served served({}, {}, folder / "served.csv");
    std::istringstream lines(chords(kChords) + "G4 P0\n");
    std::deque<std::size_t> under_way;
    std::string line, heard;
    std::size_t bytes = 0;
    bool more = static_cast<bool>(std::getline(lines, line));
    int answered = 0;
    while (more || !under_way.empty()) {
      while (more && (counts ? bytes + line.size() < kBuffer : under_way.empty())) {
        served.control->take(line + "\n", served.now);
        under_way.push_back(line.size() + 1);
        bytes += line.size() + 1;
        more = static_cast<bool>(std::getline(lines, line));
        if (!counts) heard += served.control->take_output();
        if (!counts && count_of(heard, "ok") > answered) {
          ++answered;
          bytes -= under_way.front();
          under_way.pop_front();
        }
      }
      heard += served.say("", 0.01);
      for (; answered < count_of(heard, "ok"); ++answered) {
        bytes -= under_way.front();
        under_way.pop_front();
      }
      REQUIRE(served.now < 60);
    }
    CHECK(count_of(heard, "error") == 0);
    REQUIRE(served.machine->finish().has_value());
  }
  const Trace mine = parse_trace(read(folder / "served.csv"));
  const Trace its = parse_trace(read(folder / "run.csv"));
  REQUIRE(mine.rows.size() >= its.rows.size());
  for (std::size_t i = 0; i < its.rows.size(); ++i)
    for (const char* column : {"x_mm", "y_mm", "v_mm_s"}) {
      INFO("row " << i << ' ' << column);
      REQUIRE(mine.number(i, column) == its.number(i, column));
    }
}

TEST_CASE("whatever bytes come, lines get one answer each, and limits hold",
          "[apps][serve][property]") {
  const char* asked = std::getenv("SOFTCNC_SESSIONS");
  const int sessions = asked != nullptr ? std::atoi(asked) : 20;
  const std::vector<std::string> parts{
      "G1 X5 F3000\n", "G91\n",    "G90\n",     "X-3 Y2\n",
      "G2 X4 I2\n",    "!",        "~",         "?",
      "\x18",          "\x85",     "$X\n",      "$J=G91 Y1 F2000\n",
      "\x91",          "\x92",     "M3 S500\n", "G4 P0.01\n",
      "$$\n",          "$G\n",     "M0\n",      "\x84",
      "bad line\n",    "G92 X1\n", "$C\n",      "M2\n"};
  for (int session = 0; session < sessions; ++session) {
    std::mt19937 engine(static_cast<unsigned>(session));
    const auto below = [&](std::size_t end) { return static_cast<std::size_t>(engine() % end); };
    Served served;
    AxisVector last = served.place(), speed = AxisVector::Zero();
    int lines = 0, answers = 0, rows = 0;
    bool is_reset = false;
    std::string sent;
    for (int i = 0; i < 60; ++i) {
      std::string bytes = parts[below(parts.size())];
      if (below(10) == 0) bytes = std::string(1, static_cast<char>(below(256)));
      sent += bytes;
      INFO("sent: " << sent);
      is_reset = is_reset || bytes == "\x18";
      lines += count_of(bytes, "\n") + count_of(bytes, "\r");
      served.control->take(bytes, served.now);
      for (std::size_t n = below(300); n > 0; --n, served.now += kServedPeriod) {
        const auto period = served.machine->control().last().period;
        REQUIRE(served.control->advance(served.now).has_value());
        const AxisVector v = (served.place() - last) / kServedPeriod;
        const bool breaks = served.machine->control().last().period > period + 1 ||
                            served.machine->control().pause() != nullptr;
        rows = breaks ? 0 : rows + 1;
        for (int axis = 0; axis < kAxes && rows > 2; ++axis)
          REQUIRE(std::abs(v[axis] - speed[axis]) <= 1000 * kServedPeriod * 1.001 + 1e-9);
        last = served.place();
        speed = v;
      }
      const std::string heard = served.control->take_output();
      answers += count_of(heard, "ok\r\n") + count_of(heard, "error:");
      if (bytes == "?") REQUIRE(count_of(heard, "<") >= 1);
      REQUIRE(answers <= lines);
    }
    // Where nothing was reset, each line gets its answer once nothing holds any more.
    for (int i = 0; i < 200 && !is_reset && answers < lines; ++i) {
      const std::string heard = served.say("~", 0.5);
      answers += count_of(heard, "ok\r\n") + count_of(heard, "error:");
    }
    INFO("sent: " << sent);
    if (!is_reset) CHECK(answers == lines);
  }
}

TEST_CASE("a request of HTTP is known before anything of it is run", "[apps][serve]") {
  CHECK(looks_like_http("GET / HTTP/1.1\r\n") == Http::yes);
  CHECK(looks_like_http("POST /") == Http::yes);
  CHECK(looks_like_http("G") == Http::maybe);
  CHECK(looks_like_http("OPT") == Http::maybe);
  CHECK(looks_like_http("G0 X1\n") == Http::no);
  CHECK(looks_like_http("?") == Http::no);
  CHECK(looks_like_http("$I\n") == Http::no);
  CHECK(looks_like_http("\x16\x03\x01~") == Http::yes);  // https
}

TEST_CASE("messages of errors cannot be taken for answers", "[apps][serve]") {
  CHECK(grbl_message({.code = Code::SC2001, .message = "an error: [ok] by a token"}) ==
        "[MSG:SC2001 an fault: (o-k) by a to-ken]");
  CHECK(grbl_error({.code = Code::SC2102}) == 22);
  CHECK(grbl_error({.code = Code::SC2003}) == 25);
  CHECK(grbl_error({.code = Code::SC1017}) == 2);
  CHECK(grbl_error({.code = Code::SC9001}) == 20);
}

TEST_CASE("a server without a place for senders does not begin", "[apps][serve]") {
  const Ended none = call("serve");
  CHECK(none.status == 5);
  CHECK(none.err == "softcnc: error: needs --pty LINK or --tcp PORT [SC6019]\n");
  const Folder folder;
  write(folder / "taken", "");
  const Ended taken = call("serve --pty " + (folder / "taken"));
  CHECK(taken.status == 5);
  CHECK(read(folder / "taken").empty());
  write(folder / "wrong.nc", "G1 X1\n");
  const Ended wrong = call("serve " + (folder / "wrong.nc") + " --pty " + (folder / "port"));
  CHECK(wrong.status == 1);
}
