// SPDX-License-Identifier: MIT
// What a NURBS costs: at run time by point, beforehand by curve.
#include <benchmark/benchmark.h>

#include "motion/geometry/nurbs.hpp"
#include "support/curves.hpp"
#include "support/random_nurbs.hpp"

namespace softcnc {
namespace {

/// Places in no order, so that neither caches nor branches can learn them.
std::vector<double> shuffled(double last) {
  test::Random random(1);
  std::vector<double> places(4096);
  for (double& place : places) place = random(0, last);
  return places;
}

template <typename Work>
void over(benchmark::State& state, double last, Work&& work) {
  const auto places = shuffled(last);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(work(places[i++ % places.size()]));
}

const Nurbs& butterfly() {
  static const Nurbs nurbs = Nurbs::make(test::curve_spec("butterfly")).value();
  return nurbs;
}

void point_and_derivatives_by_u(benchmark::State& state) {
  over(state, 1.0, [](double u) { return butterfly().derivatives(u); });
}
void point_by_u(benchmark::State& state) {
  over(state, 1.0, [](double u) { return butterfly().point(u); });
}
void position_by_arc_length(benchmark::State& state) {
  over(state, butterfly().length(), [](double s) { return butterfly().position(s); });
}
void at_by_arc_length(benchmark::State& state) {
  over(state, butterfly().length(), [](double s) { return butterfly().at(s); });
}
void parameter_of_arc_length(benchmark::State& state) {
  over(state, butterfly().length(), [](double s) { return butterfly().parameter(s); });
}

/// A cubic through a thousand random control points: no two spans alike.
void make_of_1000_points(benchmark::State& state) {
  test::Random random(2);
  NurbsSpec spec{3, {}, std::vector<double>(1000, 1.0), {0, 0, 0}};
  for (int i = 0; i < 1000; ++i)
    spec.control.emplace_back(random(0, 100), random(0, 100), random(0, 100));
  for (int i = 0; i <= 997; ++i) spec.knots.push_back(i);
  spec.knots.insert(spec.knots.end(), 3, 997);
  for (auto _ : state) benchmark::DoNotOptimize(Nurbs::make(spec));
}

void make_of_butterfly(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Nurbs::make(test::curve_spec("butterfly")));
}

BENCHMARK(point_and_derivatives_by_u);
BENCHMARK(point_by_u);
BENCHMARK(position_by_arc_length);
BENCHMARK(at_by_arc_length);
BENCHMARK(parameter_of_arc_length);
BENCHMARK(make_of_butterfly)->Unit(benchmark::kMillisecond);
BENCHMARK(make_of_1000_points)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace softcnc
