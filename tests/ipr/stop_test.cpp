// SPDX-License-Identifier: MIT
// Reading breaks off when it is asked to, wherever it is, and then reports nothing more.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <limits>
#include <thread>

#include "ipr/interpret.hpp"
#include "support/shown.hpp"

namespace softcnc::ipr {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto kSoon = 1s;

/// Requests a stop a little later.
class LateStop {
 public:
  std::stop_token token() const { return stop_.get_token(); }

 private:
  std::stop_source stop_;
  std::jthread thread_{[this] {
    std::this_thread::sleep_for(100ms);
    stop_.request_stop();
  }};
};

/// A pipe that is never closed; what has been written is all there is.
class OpenPipe {
 public:
  explicit OpenPipe(const std::string& text) {
    REQUIRE(::pipe(ends_) == 0);
    REQUIRE(::write(ends_[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  }
  OpenPipe(const OpenPipe&) = delete;
  OpenPipe& operator=(const OpenPipe&) = delete;
  ~OpenPipe() {
    for (const int end : ends_) ::close(end);
  }
  int reads() const { return ends_[0]; }

 private:
  int ends_[2] = {-1, -1};
};

struct Broken {
  std::size_t blocks = 0;
  bool waiting = false;
  Places reported;
  Clock::duration taken{};
};

Broken read_until_stopped(Reader reader) {
  const LateStop stop;
  Machine machine;
  machine.program.block_limit = std::numeric_limits<int>::max();
  InterpreterOptions options;
  options.stop = stop.token();
  options.unreachable_too = true;
  Diagnostics diagnostics;
  Parser parser(reader, diagnostics);
  Interpreter interpreter(parser, machine, diagnostics, options);
  const auto begin = Clock::now();
  Broken broken;
  while (interpreter.next()) ++broken.blocks;
  broken.taken = Clock::now() - begin;
  broken.waiting = interpreter.waiting();
  Interpreted all;
  all.diagnostics.assign(diagnostics.all().begin(), diagnostics.all().end());
  broken.reported = places(all);
  return broken;
}

}  // namespace

TEST_CASE("a reader gives nothing from the moment on at which it is to stop", "[ipr][stop]") {
  std::stop_source stop;
  Reader reader = Reader::from_text("a\nb\nc\n");
  reader.set_stop(stop.get_token());
  CHECK(reader.next() == "a");
  CHECK_FALSE(reader.waiting());
  stop.request_stop();
  CHECK_FALSE(reader.next());
  CHECK(reader.waiting());
  CHECK(reader.line() == 1);
}

TEST_CASE("a reader that waits for a pipe waits no longer than it may", "[ipr][stop]") {
  const OpenPipe pipe("a\nb");
  const LateStop stop;
  Reader reader(pipe.reads());
  reader.set_stop(stop.token());
  CHECK(reader.next() == "a");
  const auto begin = Clock::now();
  CHECK_FALSE(reader.next());
  CHECK(reader.waiting());
  CHECK(Clock::now() - begin < kSoon);
}

TEST_CASE("a loop without a block is left when reading is to stop", "[ipr][stop]") {
  const std::string text =
      GENERATE("G0 X1\no1 while [1]\n#1=[#1+1]\no1 endwhile\nM2\n",
               "G0 X1\no1 do\no2 if [0]\n#2=1\no2 endif\no1 while [1]\nM2\n",
               "G0 X1\no1 while [1]\no2 repeat [3]\n#1=[#1+1]\no2 endrepeat\no1 endwhile\nM2\n");
  const Broken broken = read_until_stopped(Reader::from_text(text));
  CHECK(broken.blocks == 1);
  CHECK(broken.waiting);
  CHECK(broken.reported.empty());
  CHECK(broken.taken < kSoon);
}

TEST_CASE("what is looked for when reading is to stop is not reported as missing", "[ipr][stop]") {
  const std::string text = GENERATE("G0 X1\no1 if [0]\n", "G0 X1\no1 sub\n", "G0 X1\no1 call\n",
                                    "G0 X1\no1 repeat [0]\n", "G0 X1\no1 while [0]\n");
  CAPTURE(text);
  const OpenPipe pipe(text);
  const Broken broken = read_until_stopped(Reader(pipe.reads()));
  CHECK(broken.blocks == 1);
  CHECK(broken.waiting);
  CHECK(broken.reported.empty());
  CHECK(broken.taken < kSoon);
}

TEST_CASE("a pipe is read again as far as it has come", "[ipr][stop]") {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += "a line of it\n";
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  std::jthread writer([&] { REQUIRE(::write(ends[1], text.data(), text.size()) > 0); });
  Reader reader(ends[0]);
  for (int i = 0; i < 20000; ++i) REQUIRE(reader.next() == "a line of it");
  CHECK(reader.bytes() == static_cast<std::int64_t>(text.size()));
  for (const bool ended : {false, true}) {
    if (ended) ::close(ends[1]);
    if (ended) CHECK_FALSE(reader.next());
    Reader again = reader.again();
    int lines = 0;
    while (again.next()) ++lines;
    CHECK(lines == 20000);
    CHECK(again.waiting() != ended);
  }
  ::close(ends[0]);
}

TEST_CASE("more lines than can be numbered are a failure", "[ipr][stop]") {
  Reader reader = Reader::from_text("a\nb\nc\n");
  REQUIRE(reader.seek({0, std::numeric_limits<int>::max() - 3, false}));
  CHECK(reader.next() == "a");
  CHECK(reader.next() == "b");
  CHECK_FALSE(reader.next());
  REQUIRE(reader.failure());
  CHECK(shows(render(*reader.failure()),
              "softcnc: error: cannot read more than 2147483646 lines: ... [SC6002]"));
}

TEST_CASE("loops and branches are nested ten thousand deep at most", "[ipr][stop]") {
  const auto nested = [](int levels, const std::string& begin, const std::string& end) {
    std::string text;
    for (int i = 1; i <= levels; ++i) text += "o" + std::to_string(i) + begin;
    text += "G0 X1\n";
    for (int i = levels; i >= 1; --i) text += "o" + std::to_string(i) + end;
    return interpret(text + "M2\n");
  };
  const auto [begin, end] = GENERATE(table<std::string, std::string>(
      {{" if [1]\n", " endif\n"}, {" repeat [1]\n", " endrepeat\n"}, {" do\n", " while [0]\n"}}));
  const Interpreted fits = nested(Flow::kMostLevels, begin, end);
  CHECK(fits.diagnostics.empty());
  CHECK(fits.blocks.size() == 2);
  const Interpreted refused = nested(Flow::kMostLevels + 1, begin, end);
  REQUIRE(refused.diagnostics.size() == 1);
  CHECK(shows(render(refused.diagnostics.front()),
              "softcnc:10001:1: error: more than 10000 loops and branches within each other "
              "[SC2316]"));
  CHECK(exit_status(refused.diagnostics.front()) == 1);
}

}  // namespace softcnc::ipr
