// SPDX-License-Identifier: MIT
#include "motion/model/cycle.hpp"

#include <catch2/catch.hpp>
#include <vector>

using namespace softcnc;

namespace {

struct Countdown {
  int left;
  std::optional<Setpoint> step(const Panel& panel) noexcept {
    if (left == 0 || panel.stop) return std::nullopt;
    Setpoint setpoint;
    setpoint.position[0] = left--;
    return setpoint;
  }
};

struct Mirror {
  double alarm_at = -1;
  Feedback exchange(const Setpoint& setpoint) noexcept {
    Feedback feedback;
    feedback.position = setpoint.position;
    if (setpoint.position[0] == alarm_at) feedback.alarm = Alarm::following_error;
    return feedback;
  }
};

struct Rows {
  std::vector<double> seen;
  void record(const Setpoint& setpoint, const Feedback& feedback) noexcept {
    CHECK(setpoint.position == feedback.position);
    seen.push_back(setpoint.position[0]);
  }
};

}  // namespace

TEST_CASE("the cycle passes every setpoint to the drive and every row to the recorder", "[cycle]") {
  Countdown source{4};
  Mirror drive;
  Rows rows;
  const CycleReport report = run_cycle(source, drive, rows, Panel{});
  CHECK(report.setpoints == 4);
  CHECK(rows.seen == std::vector<double>{4, 3, 2, 1});
}

TEST_CASE("an alarm ends the cycle after its row", "[cycle]") {
  Countdown source{4};
  Mirror drive{3};
  Rows rows;
  const CycleReport report = run_cycle(source, drive, rows, Panel{});
  CHECK(report.setpoints == 2);
  CHECK(report.last.alarm == Alarm::following_error);
  CHECK(rows.seen.size() == 2);
}
