// SPDX-License-Identifier: MIT
// Motions compared with each other: a higher feed or a higher limit never makes one slower, and a
// path takes as long as its reverse.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "ipo/planner/planner.hpp"
#include "support/machines.hpp"
#include "support/property.hpp"
#include "support/run.hpp"

using namespace softcnc;

namespace {

/// With sanitizers fewer do: they look for another kind of mistake.
constexpr int kChords = test::kSanitized ? 6 : 30;
constexpr double kMoreFeed = test::kSanitized ? 8 : 1.5,
                 kMoreAcceleration = test::kSanitized ? 3 : 1.4,
                 kMoreJerk = test::kSanitized ? 6 : 1.6;
constexpr double kNoSlower = 1.002, kSameTime = 0.005;
/// With jerk limits lines become curves, shaped for an estimate of the speed that limits change.
constexpr double kNoSlowerCurve = 1.006;

/// A line to a point, or an arc in the xy plane about a centre.
struct Leg {
  AxisVector to;
  std::optional<AxisVector> center{};
  bool ccw = true;
};

struct Course {
  std::string name;
  AxisVector from;
  std::vector<Leg> legs;
  double tolerance;

  Course reversed() const {
    Course back{name + ", reversed", legs.back().to, {}, tolerance};
    for (std::size_t i = legs.size(); i-- > 0;)
      back.legs.push_back({i > 0 ? legs[i - 1].to : from, legs[i].center, !legs[i].ccw});
    return back;
  }

  std::vector<Block> blocks(double feed) const {
    std::vector<std::variant<Move, Dwell, Action>> moves;
    AxisVector here = from;
    for (const Leg& leg : legs) {
      Path path = Line(here, leg.to);
      if (leg.center) path = Arc::make({here, leg.to, *leg.center, Plane::xy, leg.ccw, 0}).value();
      moves.emplace_back(
          Move{std::move(path), false, feed, PathMode::follow, tolerance, tolerance});
      here = leg.to;
    }
    return test::number_blocks(std::move(moves));
  }
};

/// Random lines in so many axes, by directions that turn by any angle.
Course chords(int axes, double length, double tolerance, int count) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(11 * axes + count));
  const auto part = [&] {
    return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1;
  };
  Course course{"chords in " + std::to_string(axes) + " axes", AxisVector::Zero(), {}, tolerance};
  AxisVector here = AxisVector::Zero();
  while (course.legs.size() < static_cast<std::size_t>(count)) {
    AxisVector direction = AxisVector::Zero();
    for (int i = 0; i < axes; ++i) direction[i] = part();
    if (direction.norm() < 0.1) continue;
    here += length * (1 + 0.5 * part()) * direction.normalized();
    course.legs.push_back({here});
  }
  return course;
}

/// Two lines of 10 mm.
Course corner_course(double turn, double heading, double tolerance) {
  const auto along = [](double angle) {
    return AxisVector(10 * std::cos(angle), 10 * std::sin(angle), 0);
  };
  const AxisVector tip = along(heading);
  return {"a corner", AxisVector::Zero(), {{tip}, {tip + along(heading + turn)}}, tolerance};
}

/// Lines and arcs that meet at corners of all kinds.
Course arcs(double size, double tolerance) {
  Course course{"lines and arcs", AxisVector::Zero(), {}, tolerance};
  AxisVector here = AxisVector::Zero();
  for (int i = 0; i < 12; ++i) {
    const AxisVector next = here + size * AxisVector(1, 0.1 * i, 0);
    course.legs.push_back({next});
    const AxisVector end = next + size * AxisVector(0.4, 0.8, 0);
    course.legs.push_back({end, 0.5 * (next + end), i % 2 == 0});
    here = end;
  }
  return course;
}

std::vector<Course> courses() {
  std::vector<Course> all;
  for (int axes = 1; axes <= 3; ++axes)
    for (const double length : {0.1, 1.0}) all.push_back(chords(axes, length, 0.01, kChords));
  for (const double degrees : {30, 90, 120, 140})
    all.push_back(corner_course(degrees * std::numbers::pi / 180, 0.7, 0.05));
  for (const double size : {0.3, 3.0}) all.push_back(arcs(size, 0.01));
  return all;
}

Machine course_machine(double acceleration, double jerk) {
  Machine machine = test::machine_with(1000, acceleration, jerk);
  machine.limits.feed = 1000;
  return machine;
}

double planned_time(const Machine& machine, const std::vector<Block>& blocks) {
  Diagnostics diagnostics;
  ipo::Planner planner(machine, 1, diagnostics);
  for (const Block& block : blocks) planner.push(block);
  planner.finish();
  double time = 0;
  while (const auto timed = planner.pop()) time = timed->t_end();
  CHECK(diagnostics.all().empty());
  return time;
}

}  // namespace

TEST_CASE("a higher feed never makes a motion slower", "[metamorphic][property]") {
  for (const double jerk : {0.0, 50'000.0})
    for (const Course& course : courses()) {
      const Machine machine = course_machine(1000, jerk);
      double fastest = ipo::kUnlimited;
      for (double feed = 5; feed < 300; feed *= kMoreFeed) {
        CAPTURE(jerk, course.name, feed);
        const double time = planned_time(machine, course.blocks(feed));
        CHECK(time <= kNoSlower * fastest);
        fastest = std::min(fastest, time);
      }
    }
}

TEST_CASE("a higher limit never makes a motion slower", "[metamorphic][property]") {
  for (const Course& course : courses())
    for (const double jerk : {0.0, 40'000.0}) {
      double fastest = ipo::kUnlimited;
      for (double acceleration = 500; acceleration < 4000; acceleration *= kMoreAcceleration) {
        CAPTURE(jerk, course.name, acceleration);
        const double time = planned_time(course_machine(acceleration, jerk), course.blocks(60));
        CHECK(time <= (jerk > 0 ? kNoSlowerCurve : kNoSlower) * fastest);
        fastest = std::min(fastest, time);
      }
    }
  for (const Course& course : courses()) {
    double fastest = ipo::kUnlimited;
    for (double jerk = 10'000; jerk < 200'000; jerk *= kMoreJerk) {
      CAPTURE(course.name, jerk);
      const double time = planned_time(course_machine(1000, jerk), course.blocks(60));
      CHECK(time <= kNoSlower * fastest);
      fastest = std::min(fastest, time);
    }
  }
}

TEST_CASE("a path takes as long as its reverse", "[metamorphic][property]") {
  std::vector<Course> all = courses();
  for (const double tolerance : {0.01, 0.05, 0.1})
    for (const double degrees : {30, 60, 90, 110, 120, 130, 136, 140, 145, 150})
      for (const double heading : {0.0, 0.7, 1.3})
        if (!test::kSanitized || degrees == 90)
          all.push_back(corner_course(degrees * std::numbers::pi / 180, heading, tolerance));
  for (const double jerk : {0.0, 50'000.0})
    for (const Course& course : all) {
      CAPTURE(jerk, course.name, course.tolerance);
      const Machine machine = course_machine(1000, jerk);
      const double there = planned_time(machine, course.blocks(66.7));
      CHECK(planned_time(machine, course.reversed().blocks(66.7)) ==
            Approx(there).epsilon(kSameTime));
    }
}
