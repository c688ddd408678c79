// SPDX-License-Identifier: MIT
// Programs that pass but once: output comes as soon as the input allows.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "apps/shell.hpp"
#include "apps/talk.hpp"
#include "hal/backends/backend.hpp"
#include "hal/files/hash.hpp"
#include "runtime/program/stream_memory.hpp"
#include "runtime/session/simulate.hpp"
#include "support/shown.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

/// Where a corner is to be rounded the line before it waits for the one after it.
const std::string kNoRounding = "control.corner_tolerance_um=0";

/// Writes the first line of a program at once, and the next one whenever the run looks up, or waits
/// for one.
class LineWriter final : public runtime::Watcher {
 public:
  LineWriter(int pipe, std::vector<std::string> lines) : pipe_(pipe), lines_(std::move(lines)) {
    write_line();  // the format of the program follows from it
  }

  bool wants_stop() override { return false; }
  void sees(const Setpoint&) override { write_line(); }
  void pause(const runtime::Pause&) override {}
  void wait_for_input(int) override { write_line(); }

 private:
  void write_line() {
    if (next_ == lines_.size()) return;
    const std::string& line = lines_[next_++];
    REQUIRE(::write(pipe_, line.data(), line.size()) == static_cast<ssize_t>(line.size()));
    if (next_ == lines_.size()) ::close(pipe_);
  }

  int pipe_;
  std::vector<std::string> lines_;
  std::size_t next_ = 0;
};

struct Positions final : runtime::RowSink {
  std::vector<AxisVector> all;
  bool row(const Setpoint& setpoint, std::span<const double>) override {
    all.push_back(setpoint.position);
    return true;
  }
};

Positions rows_of_stream(ipr::Reader& reader, int input, runtime::Watcher* watcher,
                         const runtime::ChannelOptions& options = {}) {
  Machine machine;
  machine.control.backend = BackendKind::none;
  const auto backend = hal::open_backend(machine);
  REQUIRE(backend);
  Diagnostics diagnostics;
  Positions rows;
  const runtime::Outcome outcome =
      runtime::simulate(reader, input, machine, options, **backend, diagnostics, &rows, watcher);
  CHECK(outcome.end == runtime::Outcome::End::done);
  CHECK(diagnostics.errors() == 0);
  return rows;
}

}  // namespace

TEST_CASE("blocks shows each block before the next line is written", "[apps][stream]") {
  Talk talk({"blocks", "-"});
  talk.say("G00 X1\n");
  talk.hear("{\"line\":1,\"block\":1,");
  talk.say("(nothing to do)\n\nX2\n");
  talk.hear("{\"line\":4,\"block\":2,");
  talk.say("X3");  // not yet a line
  talk.say("0\n");
  CHECK(talk.hear("{\"line\":5,\"block\":3,")[0].find("\"to\":[30,0,0]") != std::string::npos);
  talk.say("M30\n");
  talk.hear("{\"line\":6,\"block\":4,");
  CHECK(talk.finish().empty());
  CHECK(talk.status() == 0);
}

TEST_CASE("blocks shows each command of a command file before the next is written",
          "[apps][stream]") {
  Talk talk({"blocks", "-"});
  talk.say("f 600\nl 1 0\n");
  talk.hear("{\"line\":2,\"block\":1,");
  talk.say("pccw 2 0 1 0\n");
  talk.hear("{\"line\":3,\"block\":2,");
  talk.say("s 2 1 1\n");  // its second point is still to come
  talk.say("1 0\nl 1 0\n");
  CHECK(talk.hear("{\"line\":6,\"block\":4,").size() == 2);
  CHECK(talk.finish().starts_with("{\"line\":6,\"block\":5,\"kind\":\"end\""));
  CHECK(talk.status() == 0);
}

TEST_CASE("a dry run of a command file shows the rows of its first line before the second",
          "[apps][stream]") {
  Talk talk({"run", "-q", "--dry-run", "--set", kNoRounding, "-"});
  talk.say("f 600\nl 10 0\n");
  talk.hear("0.9,2,1,");
  talk.say("l 0 10\n");
  talk.hear("1.9,3,2,");
  talk.finish();
  CHECK(talk.status() == 0);
}

TEST_CASE("a dry run shows rows as soon as no later line can change them", "[apps][stream]") {
  Talk talk({"run", "-q", "--dry-run", "--set", kNoRounding, "-"});
  talk.say("G04 P0.01\n");
  const auto head = talk.hear("0.005,1,1,");
  CHECK(head[3] == "# program: -");
  CHECK(head.size() == 5 + 6);
  talk.say("G01 X1 F600\nX0\n");  // a turn: where it rests is known
  const auto there = talk.hear("0.05,2,2,");
  CHECK(there.back().find(",feed,") != std::string::npos);
  talk.say("M30\n");
  const std::string rest = talk.finish();
  CHECK(
      rest.ends_with("\n# program: " + hal::hash_hex("G04 P0.01\nG01 X1 F600\nX0\nM30\n") + "\n"));
  CHECK(talk.status() == 0);
}

TEST_CASE("a dry run shows the rows of the first line before the second is written",
          "[apps][stream]") {
  const std::string jerk = GENERATE("0.0", "50000.0");
  Talk talk({"run", "-q", "--dry-run", "--set", kNoRounding, "--set", "axis.x.jerk_mm_s3=" + jerk,
             "--set", "axis.y.jerk_mm_s3=" + jerk, "-"});
  talk.say("G01 X10 F600\n");
  const auto first = talk.hear("0.9,1,1,");
  CHECK(first.back().find(",feed,") != std::string::npos);
  talk.say("Y10\n");
  const auto second = talk.hear("1.9,2,2,");
  CHECK(second.back().find(",feed,") != std::string::npos);
  talk.say("M30\n");
  talk.finish();
  CHECK(talk.status() == 0);
}

TEST_CASE("check reports what is wrong with a line before the next one is written",
          "[apps][stream]") {
  Talk talk({"check", "-"});
  talk.say("G01 X1 Q3 F600\n");
  CHECK(talk.hear("<stdin>:1:8: error: ... [SC2004]").size() == 1);
  talk.hear("      | ");
  talk.say("G00 X5\nY2000\n");
  CHECK(talk.hear("<stdin>:3:1: error: ... [SC4001]").size() == 1);
  talk.hear("      | ");
  talk.say("(nothing)\nG02 X3\nM30\n");
  CHECK(talk.hear("<stdin>:5:5: error: ... [SC2107]").size() == 1);
  talk.hear("      | ");
  CHECK(talk.finish().empty());
  CHECK(talk.status() == 1);
}

TEST_CASE("a warning of check does not wait for an error", "[apps][stream]") {
  Talk talk({"check", "-"});
  talk.say("G01 X1 F99999\n");
  talk.hear("<stdin>:1:8: warning: ... [SC2201]");
  talk.hear("      | ");
  talk.say("M30\n");
  CHECK(talk.finish().empty());
  CHECK(talk.status() == 0);
}

TEST_CASE("check reports the same of a pipe as of a file", "[apps][stream]") {
  const Folder folder;
  write(folder / "p.nc", "G01 X1 Q3 F99999\nY20\nG02 X3\n#1=\nX1 X2\n");
  for (const char* form : {"text", "json", "sarif"}) {
    CAPTURE(form);
    const std::string check = std::string("check --diagnostics ") + form;
    std::string file = call(check + " " + (folder / "p.nc")).out;
    const std::string piped = shell("cat " + (folder / "p.nc") + " | $softcnc " + check + " -").out;
    const std::string name = folder / "p.nc";
    for (std::size_t at = 0; (at = file.find(name, at)) != std::string::npos;)
      file.replace(at, name.size(), "<stdin>");
    CHECK(!piped.empty());
    if (std::string(form) != "sarif") CHECK(piped == file);
  }
}

TEST_CASE("a dry run that waits for its input stops at Ctrl-C", "[apps][stream]") {
  const std::string said = GENERATE("", "G04 P0.01\n", "G01 X10 F600\n");
  Talk talk({"run", "-q", "--dry-run", "--set", kNoRounding, "-"});
  talk.say(said);
  talk.hear("# machine: ");
  talk.send(SIGINT);
  CHECK(talk.hear_rest().find("# program:") == std::string::npos);
  CHECK(talk.status() == 130);
}

TEST_CASE("a streamed program gives the rows of the file, and its hash at the end",
          "[apps][stream]") {
  for (const char* part : {"$data/square.nc", "$programs/08_butterfly.nc", "$data/zigzag.nc"}) {
    const std::string file = call(std::string("run -q --dry-run ") + part).out;
    std::string piped = shell(std::string("cat ") + part + " | $softcnc run -q --dry-run -").out;
    const std::string key = "# program: ";
    const std::size_t hash = file.find(key);
    const std::string line = file.substr(hash, file.find('\n', hash) + 1 - hash);
    CHECK(piped.ends_with('\n' + line));
    piped.erase(piped.size() - line.size());
    piped.replace(piped.find("# program: -\n"), std::string("# program: -\n").size(), line);
    CHECK(piped == file);
  }
}

TEST_CASE("lines that come while rows are written are not the end of the program",
          "[apps][stream]") {
  std::vector<std::string> lines{"G61 F3000\n"};
  for (int i = 1; i < 150; ++i)
    lines.push_back("G01 X" + std::to_string(0.1 * i) + " Y" + std::to_string(0.05 * (i % 2)) +
                    "\n");
  std::string text;
  for (const std::string& line : lines) text += line;
  ipr::Reader whole = ipr::Reader::from_text(text);
  const Positions expected = rows_of_stream(whole, -1, nullptr);

  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  LineWriter writer(ends[1], lines);
  ipr::Reader reader(ends[0]);
  const Positions rows = rows_of_stream(reader, ends[0], &writer);
  ::close(ends[0]);
  CHECK(expected.all.size() > 1000);
  CHECK(rows.all == expected.all);
}

TEST_CASE("an override or a hold falls on the same way, however slowly the lines come",
          "[apps][stream]") {
  const std::vector<std::string> lines{"G61 F600\n", "G1 X5\n", "X10\n", "Y10\n",
                                       "X0\n",       "Y0\n",    "M30\n"};
  runtime::ChannelOptions options;
  using Kind = runtime::FeedEvent::Kind;
  options.events =
      GENERATE(std::vector<runtime::FeedEvent>{{0.1, Kind::override_, 50}},
               std::vector<runtime::FeedEvent>{{0.1, Kind::hold}, {0.4, Kind::resume}});
  std::string text;
  for (const std::string& line : lines) text += line;
  ipr::Reader whole = ipr::Reader::from_text(text);
  const Positions expected = rows_of_stream(whole, -1, nullptr, options);

  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  LineWriter writer(ends[1], lines);
  ipr::Reader reader(ends[0]);
  const Positions rows = rows_of_stream(reader, ends[0], &writer, options);
  ::close(ends[0]);
  CHECK(expected.all.size() > 4000);
  CHECK(rows.all == expected.all);
}

TEST_CASE("what is wrong with a streamed program is shown with its line", "[apps][stream]") {
  std::string part = "G90 G01 F600\n";
  for (int i = 0; i < 20000; ++i) part += "(" + std::to_string(i) + ")\n";
  const Folder folder;
  write(folder / "p.nc", part + "Y2000\nX Y1\nM30\n");
  for (const char* command : {"check -", "run --dry-run - 2>&1 >/dev/null", "blocks - 2>&1"}) {
    CAPTURE(command);
    const std::string out = shell("cat " + (folder / "p.nc") + " | $softcnc " + command).out;
    if (std::string(command) != "blocks - 2>&1") {
      CHECK(shows(out, "<stdin>:20002:1: error: Y reaches 2000 mm... [SC4001]"));
      CHECK(out.find("20002 | Y2000\n") != std::string::npos);
    }
    CHECK(out.find("20003 | X Y1\n") != std::string::npos);
  }
}

TEST_CASE("a named pipe is a program as any other", "[apps][stream]") {
  const Folder folder;
  const std::string fifo = folder / "fifo";
  const Ended ended =
      shell("mkfifo " + fifo + "; cat $data/square.nc >" + fifo + " & $softcnc blocks " + fifo);
  CHECK(ended.status == 0);
  CHECK(ended.out == call("blocks $data/square.nc").out);
}

TEST_CASE("a stream is remembered by its hash and its latest lines", "[apps][stream]") {
  runtime::StreamMemory memory;
  std::string text;
  for (int i = 1; i <= 200000; ++i)
    text += "line " + std::to_string(i) + (i % 3 == 0 ? "\r\n" : i % 3 == 1 ? "\n" : "\r");
  for (std::size_t at = 0; at < text.size(); at += 997)
    memory.add(std::string_view(text).substr(at, 997));
  CHECK(memory.hash() == hal::hash_hex(text));
  CHECK(memory.line(200000) == "line 200000");
  CHECK(memory.line(190000) == "line 190000");
  CHECK(memory.line(1).empty());
  CHECK(memory.line(200001).empty());
}

TEST_CASE("a dry run comes to rest where its pipe pauses, with --rest-at-pauses",
          "[apps][stream]") {
  const std::vector<std::string> rests{"run", "--dry-run", "--rest-at-pauses", "-"};
  Talk talk(rests);
  talk.say("G01 X10 F3000\n");
  talk.hear("0.25,1,1,10,0,0,stop,10,0,0,");  // the end of the line, though nothing follows yet
  talk.say("X20 Y5\n");
  talk.hear("0.521,2,2,21.1803398874989");
  talk.say("M30\n");
  talk.finish();
  CHECK(talk.status() == 0);
}

TEST_CASE("rests at pauses leave a pipe that does not pause as it is", "[apps][stream]") {
  const std::string cat = "cat $programs/08_butterfly.nc | $softcnc run --dry-run - ";
  const Ended plain = shell(cat), told = shell(cat + "--rest-at-pauses");
  CHECK(plain.status == 0);
  CHECK(told.out == plain.out);
}
