// SPDX-License-Identifier: MIT
// --at: override, hold and resume at given moments of a run, the same in its replay.
#include "runtime/session/feed_script.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "apps/shell.hpp"

using namespace softcnc;
using namespace softcnc::app;
using namespace softcnc::app::test;

namespace {

constexpr const char* kLongLine = "G01 X200 F6000\nM30\n";
constexpr const char* kEvents = " --at 3:resume --at 0.5:override=57 --at 2:hold";

}  // namespace

TEST_CASE("override, hold and resume take effect at their moments", "[apps][replan]") {
  const std::string jerk = GENERATE("", " --set axis.x.jerk_mm_s3=50000");
  const Ended ended = call("run -q --dry-run" + jerk + kEvents + " -", kLongLine);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  const Trace trace = parse_trace(ended.out);
  CHECK(trace.number(500, "v_mm_s") == Approx(100).epsilon(1e-3));
  CHECK(trace.word(500, "limit") == "feed");
  CHECK(trace.number(700, "v_mm_s") == Approx(57).epsilon(1e-3));
  CHECK(trace.word(700, "limit") == "override");
  CHECK(trace.number(2000, "v_mm_s") == Approx(57).epsilon(1e-3));
  for (const std::size_t row : {2200U, 3000U}) {
    CHECK(trace.number(row, "v_mm_s") == 0);
    CHECK(trace.word(row, "limit") == "hold");
    CHECK(trace.word(row, "x_mm") == trace.word(2500, "x_mm"));
  }
  CHECK(trace.number(3200, "v_mm_s") == Approx(57).epsilon(1e-3));
  CHECK(trace.rows.back()[7] == "200");
}

TEST_CASE("no override changes the pitch of a tap, before a hold or after it", "[apps][replan]") {
  const Ended ended = call("run -q --dry-run --at 0.5:override=50 --at 1:hold --at 1.5:resume -",
                           "F600 S600 M03\nG00 Z5\nG84 Z-20 R2\nG80\nG01 Z5\nM30\n");
  CHECK(ended.status == 0);
  const Trace trace = parse_trace(ended.out);
  for (const std::size_t row : {400U, 700U, 1900U, 4000U}) {  // down, down, down again, up
    CHECK(std::abs(trace.number(row, "v_mm_s") - 10) < 1e-6);
    CHECK(trace.number(row, "feed_mm_s") == 10);
    CHECK(trace.word(row, "limit") == "feed");
  }
  CHECK(trace.number(1300, "v_mm_s") == 0);
  CHECK(trace.word(1300, "limit") == "hold");
  const std::size_t last = trace.rows.size() - 100;  // of G01, where the override counts again
  CHECK(trace.word(last, "line") == "5");
  CHECK(trace.number(last, "feed_mm_s") == 5);
}

TEST_CASE("a recording keeps the events, and a replay answers them", "[apps][recording][replan]") {
  const Folder folder;
  write(folder / "p.nc", kLongLine);
  const std::string file = folder / "p.rec";
  const Ended recorded = call("record " + (folder / "p.nc") + " -o " + file + kEvents +
                              " --report " + (folder / "r.json"));
  CHECK(recorded.status == 0);
  const auto report = nlohmann::json::parse(read(folder / "r.json"));
  // Held from 2 s on, on the way to rest too.
  CHECK(report["time_by_limit_s"]["hold"].get<double>() == Approx(1).margin(1e-3));
  double sum = 0;
  for (const auto& time : report["time_by_limit_s"]) sum += time.get<double>();
  CHECK(sum == Approx(report["time_s"].get<double>()).epsilon(1e-9));
  CHECK(call("replay -q " + file).status == 0);
}

TEST_CASE("a moment after the end is reported", "[apps][replan]") {
  const Ended ended = call("run --dry-run --trace /dev/null --at 60:override=50 -", kLongLine);
  CHECK(ended.status == 0);
  CHECK(ended.err.find("--at 60:override=50 was not reached: the program ended first\n") !=
        std::string::npos);
}

TEST_CASE("events that say nothing, or hold for ever, are wrong usage", "[apps][cli][replan]") {
  for (const char* word : {"hold", "1", "1:", "-1:hold", "x:hold", "1:holds", "1:override",
                           "1:override=", "1:override=201", "1:override=-1", "1:override=5x",
                           "nan:hold", "1:rapid=0", "1:rapid=101", "1:rapid=", "1:rapids=50"}) {
    CAPTURE(word);
    const Ended ended = call(std::string("run $data/square.nc --at ") + word);
    CHECK(ended.status == 2);
    CHECK(ended.err.find("--at: takes SECONDS:override=PERCENT (0 to 200), SECONDS:rapid=PERCENT "
                         "(1 to 100), SECONDS:hold or "
                         "SECONDS:resume, not '" +
                         std::string(word) + "'") != std::string::npos);
  }
  for (const char* words : {"--at 1:hold", "--at 1:override=0", "--at 2:hold --at 1:resume"}) {
    CAPTURE(words);
    const Ended ended = call(std::string("run $data/square.nc ") + words);
    CHECK(ended.status == 2);
    CHECK(ended.err.find("holds the program for ever") != std::string::npos);
  }
}

TEST_CASE("the text of an event reads back as the same", "[apps][replan]") {
  for (const char* text :
       {"0.1:override=57", "0:hold", "12.345:resume", "1e-05:override=0.3", "2:rapid=25"}) {
    const auto event = runtime::parse_event(text);
    REQUIRE(event);
    CHECK(runtime::event_text(*event) == text);
  }
}
