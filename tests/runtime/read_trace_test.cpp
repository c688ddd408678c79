// SPDX-License-Identifier: MIT
// The rows of a trace as rows of a run.
#include "runtime/history/read_trace.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <vector>

#include "support/folder.hpp"

namespace softcnc::runtime {
namespace {

using softcnc::test::Folder;

class KeptRows final : public RunRowSink {
 public:
  void take(const RunRow& row) override { rows.push_back(row); }
  std::vector<RunRow> rows;
};

struct ReadBack {
  Result<TraceFacts> facts;
  std::vector<RunRow> rows;
};

ReadBack read_text(const std::string& text) {
  const Folder folder;
  const std::string file = folder / "t.csv";
  std::ofstream(file) << text;
  KeptRows kept;
  auto facts = read_trace(file, kept);
  return {std::move(facts), std::move(kept.rows)};
}

std::string problem(const std::string& text) {
  const ReadBack read = read_text(text);
  REQUIRE_FALSE(read.facts);
  CHECK(read.facts.error().code == Code::SC6082);
  return std::to_string(read.facts.error().pos.line) + ": " + read.facts.error().message;
}

const std::string kNames = "t_s,line,block,s_mm,v_mm_s,a_mm_s2,limit,x_mm,z_mm,feed_mm_s\n";
const std::string kComment = "# period_ms: 2\n# program: aa\n# machine: bb\n";

}  // namespace

TEST_CASE("rows of a trace are rows of a run", "[runtime][trace]") {
  const ReadBack read = read_text(
      "t_s,line,block,s_mm,v_mm_s,a_mm_s2,limit,x_mm,z_mm,feed_mm_s,x_act_mm,contour_um,"
      "chord_error_um,rmax_um\n" +
      kComment +
      "0,3,1,0,0,1000,stop,0,-1,100,0,0.5,0.25,nan\n"
      "0.002,3,1,0.5,7,1000,chord,0.5,-1,100,0,1.5,0.125,2.5\n"
      "0.004,4,2,0.5,0,0,stop,0.5,-1,0,0,0,0,nan\n"
      "0.006,5,3,1,9,0,rapid,0.5,-1.5,0,0,0,0,nan\n");
  REQUIRE(read.facts);
  CHECK(read.facts->period == 0.002);
  CHECK(read.facts->program_hash == "aa");
  CHECK(read.facts->machine_hash == "bb");
  CHECK(read.facts->axes == std::vector<char>{'x', 'z'});
  CHECK(read.facts->rows == 4);
  REQUIRE(read.rows.size() == 4);
  const RunRow& row = read.rows[1];
  CHECK(row.period == 1);
  CHECK(row.line == 3);
  CHECK(row.block == 1);
  CHECK(row.limit == Limit::chord);
  CHECK(row.s == 0.5);
  CHECK(row.v == 7);
  CHECK(row.feed == 100);
  CHECK(row.position == AxisVector(0.5, 0, -1));
  CHECK(row.contour == 1.5F);
  CHECK(row.chord_error == 0.125F);
  CHECK(row.rmax == 2.5F);
  CHECK(std::isnan(row.deviation));
  CHECK(std::isnan(row.rmax_target));
  CHECK(std::isnan(read.rows[0].rmax));
  CHECK(read.rows[0].motion == MotionKind::rest);
  CHECK(row.motion == MotionKind::cutting);
  CHECK(read.rows[2].motion == MotionKind::rest);
  CHECK(read.rows[3].motion == MotionKind::rapid);
}

TEST_CASE("a trace of schema 1 has no feed", "[runtime][trace]") {
  const ReadBack read = read_text(
      "# schema: softcnc-trace 1\n# period_ms: 1\n"
      "t_s,line,block,s_mm,v_mm_s,a_mm_s2,limit,x_mm\n"
      "0,1,1,0,0,1,stop,0\n0.001,1,1,1,1,1,feed,1\n0.002,1,1,2,1,1,rapid,2\n");
  REQUIRE(read.facts);
  REQUIRE(read.rows.size() == 3);
  CHECK(read.rows[1].motion == MotionKind::cutting);
  CHECK(read.rows[2].motion == MotionKind::rapid);
  CHECK(read.rows[1].feed == 0);
}

TEST_CASE("a trace without comments has the period of its first rows", "[runtime][trace]") {
  const ReadBack read = read_text(kNames +
                                  "0,1,1,0,0,0,stop,0,0,1\n0.25,1,1,0,0,0,stop,0,0,1\n"
                                  "0.75,1,1,0,0,0,stop,1,0,1\n");
  REQUIRE(read.facts);
  CHECK(read.facts->period == 0.25);
  REQUIRE(read.rows.size() == 3);
  CHECK(read.rows[1].period == 1);
  CHECK(read.rows[2].period == 3);
  CHECK(read.rows[2].motion == MotionKind::cutting);
  const ReadBack one = read_text(kNames + "0,1,1,0,0,0,stop,7,0,1\n");
  REQUIRE(one.facts);
  CHECK(one.facts->rows == 1);
  CHECK(one.rows.front().position[0] == 7);
  const ReadBack none = read_text(kNames + kComment);
  REQUIRE(none.facts);
  CHECK(none.facts->rows == 0);
  CHECK(none.facts->period == 0.002);
}

TEST_CASE("what no run can have is reported with its line", "[runtime][trace][code]") {
  const std::string good = "0,1,1,0,0,0,stop,0,0,1\n";
  CHECK(problem("a,b\n1,2\n") == "0: is no trace: it has no column t_s");
  CHECK(problem("t_s,line,block,s_mm,v_mm_s,limit\n") == "0: is no trace: it has no column x_mm");
  CHECK(problem(kNames + kComment + good + good) == "6: not later than the row before");
  CHECK(problem(kNames + good + good) == "3: not later than the row before");
  CHECK(problem(kNames + kComment + good + "0.003,1,1,0,0,0,stop,0,0,1\n") ==
        "6: no whole number of periods");
  CHECK(problem(kNames + "0,1,1,nan,0,0,stop,0,0,1\n") == "2: no finite number");
  CHECK(problem(kNames + "0,1,1,0,0,0,stop,inf,0,1\n") == "2: a position beyond 1000 m");
  CHECK(problem(kNames + "0,1,1,0,0,0,stop,nan,0,1\n") == "2: no finite number");
  CHECK(problem(kNames + "0,1.5,1,0,0,0,stop,0,0,1\n") == "2: no number of a line or a block");
  CHECK(problem(kNames + "0,1,9e9,0,0,0,stop,0,0,1\n") == "2: no number of a line or a block");
}

}  // namespace softcnc::runtime
