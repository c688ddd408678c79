// SPDX-License-Identifier: MIT
// Hooks, cusps and tiny curves on random machines with jerk limits: long periods hardly cost time
// there, and planning stays short.
//
// SOFTCNC_PROGRAMS sets how many are tried: scripts/stress programs.
#include <catch2/catch.hpp>

#include "ipo/limits/chord_error.hpp"
#include "support/property.hpp"
#include "support/random_program.hpp"
#include "support/run.hpp"

using namespace softcnc;
using namespace softcnc::test;

namespace {

constexpr double kSecondsOfWork = 4e-7;  // tuning::horizon::kWorkPerSecond

double power(double low, double high) { return std::pow(10, real(low, high)); }

AxisVector anywhere(double size) { return size * AxisVector(real(-1, 1), real(-1, 1), 0); }

/// Goes a long way and ends in a hook of some micrometres or less.
std::vector<AxisVector> hook() {
  std::vector<AxisVector> control{AxisVector::Zero(), anywhere(power(-1, 1.3))};
  const double size = power(-5, -2);
  for (int more = integer(2, 3); more > 0; --more)
    control.emplace_back(control.back() + anywhere(size));
  return control;
}

/// Turns back at a cusp, or nearly so.
std::vector<AxisVector> cusp() {
  const double size = power(-3, 0.5), off = power(-8, -1);
  std::vector<AxisVector> control;
  for (const AxisVector& corner :
       {AxisVector(0, 0, 0), AxisVector(1, 1, 0), AxisVector(0, 1, 0), AxisVector(1, 0, 0)})
    control.emplace_back(size * (corner + anywhere(off)));
  return control;
}

std::vector<AxisVector> tiny() {
  const double size = power(-6, -2);
  std::vector<AxisVector> control;
  for (int i = integer(4, 6); i > 0; --i) control.emplace_back(anywhere(size));
  return control;
}

/// The cubic B-spline on even knots.
Result<Nurbs> spline(const std::vector<AxisVector>& control, const AxisVector& start) {
  NurbsSpec spec;
  spec.degree = 3;
  for (const AxisVector& point : control) {
    spec.control.emplace_back(start + point - control.front());
    spec.weights.push_back(power(-0.5, 0.5));
  }
  const auto inner = static_cast<double>(control.size() - 4);
  spec.knots.assign(4, 0.0);
  for (double knot = 1; knot <= inner; ++knot) spec.knots.push_back(knot);
  spec.knots.insert(spec.knots.end(), 4, inner + 1);
  return Nurbs::make(spec);
}

std::vector<Block> sharp_program() {
  std::vector<std::variant<Move, Dwell, Action>> moves;
  AxisVector here = AxisVector::Zero();
  const double feed = power(0, 2.2);
  for (int i = integer(1, 3); i > 0; --i) {
    const int kind = integer(0, 2);
    const auto curve = spline(kind == 0 ? hook() : kind == 1 ? cusp() : tiny(), here);
    if (!curve) continue;
    moves.emplace_back(Move{*curve, false, feed, PathMode::follow});
    here = end(*curve);
  }
  return number_blocks(std::move(moves));
}

/// Returns how many samples the chord tolerance requires, by looks at even distances; the steps on
/// either side of a sharp place are about as short as in it, which counts half as much again.
double samples_by_chord(const Path& path, double tolerance) {
  constexpr int kLooks = 4000;
  const double step = length(path) / kLooks;
  double samples = 0;
  for (int i = 0; i < kLooks; ++i)
    samples += step / ipo::chord_step(at(path, (i + 0.5) * step).ddq.norm(), tolerance);
  return 1.5 * samples;
}

}  // namespace

TEST_CASE("a hook of 6 um takes about as long at every period", "[ipo][jerk][hook]") {
  Machine machine;
  machine.limits.normal = 68.367;
  machine.control.chord_tolerance = 2.946e-4;
  for (Axis& axis : machine.axes) {
    axis.velocity = 785;
    axis.acceleration = 2883.1;
    axis.jerk = 2905.2;
  }
  const std::vector<AxisVector> control{
      {0, 0, 0}, {12, 9, 0}, {12, 8.999, 0}, {11.995, 8.997, 0}, {12, 8.999, 0}};
  const std::vector<double> even(5, 1.0), weighted{1, 1.7, 0.4, 1, 0.6};
  for (const auto& weights : {even, weighted}) {
    const Nurbs hook = Nurbs::make({3, control, weights, {0, 0, 0, 0, 1, 2, 2, 2, 2}}).value();
    const auto blocks = number_blocks({Move{hook, false, 875.0 / 60, PathMode::follow}});
    machine.control.period = 2.5e-4;
    const double least = run(machine, blocks).time;
    for (const double period : {1e-3, 4e-3, 8e-3}) {
      CAPTURE(weights, period);
      machine.control.period = period;
      const auto result = run(machine, blocks);
      CHECK(exceeded(machine, result) == "");
      CHECK(result.time <= 1.2 * least + 2 * period);
      CHECK(kSecondsOfWork * static_cast<double>(result.counts.effort.work) <=
            0.2 + 0.5 * result.time);
    }
  }
}

TEST_CASE("hooks, cusps and tiny curves cost hardly more time at long periods",
          "[ipo][jerk][property][hook]") {
  int tried = 0, slow = 0;
  holds(
      [&] {
        std::mt19937 random(static_cast<unsigned>(integer(1, 1'000'000'000)));
        Machine machine = random_machine(random);
        const auto blocks = sharp_program();
        RC_PRE(!blocks.empty());
        machine.control.period = 2.5e-4;
        const double least = run(machine, blocks).time;
        machine.control.period = power(-3, -2.1);
        const auto result = run(machine, blocks);
        double samples = 2.0 * static_cast<double>(blocks.size());
        for (const Block& block : blocks)
          samples +=
              samples_by_chord(std::get<Move>(block.what).path, machine.control.chord_tolerance);
        const double expected = 1.2 * least + samples * machine.control.period;
        ++tried;
        slow += result.time > expected ? 1 : 0;
        RC_ASSERT(exceeded(machine, result) == "");
        RC_ASSERT(result.time <= 10 * expected);
        RC_ASSERT(kSecondsOfWork * static_cast<double>(result.counts.effort.work) <=
                  0.2 + 0.5 * result.time);
      },
      programs_asked(100));
  INFO(slow << " of " << tried << " programs took longer");
  CHECK(20 * slow <= tried + 20);
}
