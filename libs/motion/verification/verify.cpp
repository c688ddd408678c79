// SPDX-License-Identifier: MIT
#include "motion/verification/verify.hpp"

#include <algorithm>
#include <cmath>

#include "motion/geometry/deviation.hpp"
#include "motion/roughness/roughness.hpp"

namespace softcnc {
namespace {

constexpr int kChordSamples = 8;
constexpr double kIntegration = 1e-9;
constexpr int kDepth = 20;
constexpr double kSmallestAdvance = 1e-3;  // mm; interfaces: feed_fluctuation_max
constexpr double kSamePlace = 1e-9;        // mm along the path: rounding
constexpr double kMost = 0.99;             // of the periods

// Gauss-Legendre nodes and weights on [-1, 1], the positive half; they integrate polynomials of
// degree 15 exactly (Abramowitz and Stegun, table 25.4).
constexpr std::array<double, 4> kGaussNode{0.183434642495649805, 0.525532409916328986,
                                           0.796666477413626740, 0.960289856497536232};
constexpr std::array<double, 4> kGaussWeight{0.362683783378361983, 0.313706645877887287,
                                             0.222381034453374471, 0.101228536290376259};

double gauss(const Nurbs& nurbs, double u0, double u1) noexcept {
  const double middle = 0.5 * (u0 + u1), half = 0.5 * (u1 - u0);
  double sum = 0;
  for (std::size_t i = 0; i < kGaussNode.size(); ++i)
    sum += kGaussWeight[i] * (nurbs.speed(middle - half * kGaussNode[i]) +
                              nurbs.speed(middle + half * kGaussNode[i]));
  return sum * half;
}

/// Halves until both halves agree with the whole.
double gauss_adaptive(const Nurbs& nurbs, double u0, double u1, double whole, int depth) noexcept {
  const double middle = 0.5 * (u0 + u1);
  const double left = gauss(nurbs, u0, middle), right = gauss(nurbs, middle, u1);
  if (depth == 0 || std::abs(left + right - whole) <= kIntegration * whole) return left + right;
  return gauss_adaptive(nurbs, u0, middle, left, depth - 1) +
         gauss_adaptive(nurbs, middle, u1, right, depth - 1);
}

double integrate_span(const Nurbs& nurbs, double u0, double u1) noexcept {
  return gauss_adaptive(nurbs, u0, u1, gauss(nurbs, u0, u1), kDepth);
}

double integrate(const Nurbs& nurbs, double s0, double s1) noexcept {
  double sum = 0, u = nurbs.parameter(s0);
  const auto inner = nurbs.breaks();
  for (auto at = std::upper_bound(inner.begin(), inner.end(), s0); at != inner.end() && *at < s1;
       ++at) {
    const double u_break = nurbs.parameter(*at);
    sum += integrate_span(nurbs, u, u_break);
    u = u_break;
  }
  return sum + integrate_span(nurbs, u, nurbs.parameter(s1));
}

}  // namespace

Verifier::Verifier(const Machine& machine)
    : by_pulses_(is_by_pulses(machine.control.interpolation)),
      off_path_(accelerates_after(machine.control.interpolation)),
      period_(by_pulses_ ? machine.control.period : fine_period(machine.control)),
      parts_(parts_of_period(machine.control, period_)),
      staircase_(machine),
      model_(machine.surfacing.model),
      limits_normal_(machine.limits.normal > 0) {}

void Verifier::sample(const Setpoint& setpoint, std::span<const PathStretch> stretches) noexcept {
  if (measured_.samples == 0) {
    last_.fill(setpoint.position);
    last_s_.fill(setpoint.s);
    if (by_pulses_) staircase_.start(setpoint, stretches);
  } else {
    geometry(setpoint, stretches);
  }
  for_each_instant(setpoint, [this](const FinePoint& point) {
    push(point);
    differences();
  });
  before_ = setpoint;
  ++measured_.samples;
}

Measured Verifier::measured() const noexcept {
  Measured measured = measured_;
  measured.feed_fluctuation = feed_.largest();
  measured.feed_fluctuation_rms = feed_.rms();
  measured.feed_fluctuation_p99 = feed_.percentile(kMost);
  measured.chord_fluctuation = chord_.largest();
  measured.chord_fluctuation_rms = chord_.rms();
  measured.chord_fluctuation_p99 = chord_.percentile(kMost);
  return measured;
}

void Verifier::pass_over(const Setpoint& setpoint) noexcept {
  for_each_instant(setpoint, [this](const FinePoint& point) { push(point); });
  last_period_ = {};
  measured_.samples += setpoint.period - before_.period;
  before_ = setpoint;
}

void Verifier::finish() noexcept {
  if (measured_.samples == 0) return;
  for (int i = 0; i < 3; ++i) {
    push({before_.s, before_.position});
    differences();
  }
}

template <typename Visit>
void Verifier::for_each_instant(const Setpoint& setpoint, Visit&& visit) noexcept {
  for_instants(setpoint, {before_.s, before_.position}, measured_.samples > 0 ? parts_ : 1, visit);
}

void Verifier::push(const FinePoint& point) noexcept {
  std::rotate(last_.begin(), last_.end() - 1, last_.end());
  last_[0] = point.position;
  std::rotate(last_s_.begin(), last_s_.end() - 1, last_s_.end());
  last_s_[0] = point.s;
}

void Verifier::differences() noexcept {
  const AxisVector first = last_[0] - last_[1];
  const AxisVector second = last_[0] - 2 * last_[1] + last_[2];
  const AxisVector third = last_[0] - 3 * last_[1] + 3 * last_[2] - last_[3];
  const auto raise = [](AxisVector& largest, const AxisVector& value) {
    largest = largest.cwiseMax(value.cwiseAbs());
  };
  raise(measured_.velocity, first / period_);
  raise(measured_.acceleration, second / (period_ * period_));
  raise(measured_.jerk, third / (period_ * period_ * period_));
  const double along_path = last_s_[0] - 2 * last_s_[1] + last_s_[2];
  measured_.tangential = std::max(measured_.tangential, std::abs(along_path) / (period_ * period_));
}

void Verifier::geometry(const Setpoint& setpoint, std::span<const PathStretch> stretches) noexcept {
  double travelled = 0;
  bool cuts = false, rapids = false;
  last_period_ = {};
  for (const PathStretch& stretch : stretches) {
    const double s_end = softcnc::length(*stretch.path);
    const double s0 = std::clamp(before_.s - stretch.s_start, 0.0, s_end);
    const double s1 = std::clamp(setpoint.s - stretch.s_start, 0.0, s_end);
    if (s1 <= s0) continue;
    if (!by_pulses_)
      last_period_.chord_error =
          std::max(last_period_.chord_error,
                   chord_error(*stretch.path, s0, s1, before_.position, setpoint.position));
    travelled += integrated_length(*stretch.path, s0, s1);
    if (s1 > s0 + kSamePlace) (stretch.rapid ? rapids : cuts) = true;
  }
  if (!by_pulses_ && travelled > 0) chord(last_period_.chord_error);
  if (!stretches.empty()) {
    const PathStretch& here = stretch_at(stretches, setpoint.s);
    const double s = std::clamp(setpoint.s - here.s_start, 0.0, softcnc::length(*here.path));
    if (here.surface) roughness(setpoint, here);
    if (limits_normal_)
      measured_.normal =
          std::max(measured_.normal, setpoint.v * setpoint.v * at(*here.path, s).ddq.norm());
    closeness(setpoint, stretches);
  }
  const double chord = (setpoint.position - before_.position).norm();
  if (setpoint.advance <= kSmallestAdvance) return;
  last_period_.feed_fluctuation = (off_path_ ? chord : travelled) / setpoint.advance - 1;
  if (cuts && rapids) return;
  feed_.add(last_period_.feed_fluctuation);
  chord_.add(chord / setpoint.advance - 1);
}

/// Pulses run no chord: how far they are from the curve is the error of the period.
void Verifier::closeness(const Setpoint& setpoint,
                         std::span<const PathStretch> stretches) noexcept {
  if (by_pulses_) {
    staircase_.period(before_, setpoint, stretches);
    measured_.path_deviation = measured_.chord_error = staircase_.largest();
    measured_.path_deviation_mean = staircase_.mean();
    last_period_.chord_error = staircase_.largest_of_period();
    return;
  }
  const PathStretch& here = stretch_at(stretches, setpoint.s);
  const double s_end = softcnc::length(*here.path);
  double s = std::clamp(setpoint.s - here.s_start, 0.0, s_end);
  if (off_path_) s = nearest({here.path, 0, s_end}, setpoint.position, s);
  measured_.path_deviation =
      std::max(measured_.path_deviation, (position(*here.path, s) - setpoint.position).norm());
}

void Verifier::chord(double error) noexcept {
  chord_errors_ += error * error;
  ++chords_;
  measured_.chord_error = std::max(measured_.chord_error, error);
  measured_.chord_error_rms = std::sqrt(chord_errors_ / static_cast<double>(chords_));
}

/// Teeth that rub are not asked to be slower.
void Verifier::roughness(const Setpoint& setpoint, const PathStretch& here) noexcept {
  constexpr double kRounding = 1e-6;
  const Surface& surface = *here.surface;
  const double feed = surface.tooth_rate() > 0 ? setpoint.v / surface.tooth_rate() : 0;
  const double s = std::clamp(setpoint.s - here.s_start, 0.0, softcnc::length(*here.path));
  const PathPoint point = at(*here.path, s);
  last_period_.rmax = rmax(model_, surface, feed, point);
  if (feed <= kLeastFeedPerTooth * (1 + kRounding)) return;
  if (last_period_.rmax * measured_.rmax_target <= measured_.rmax * surface.rmax &&
      measured_.rmax_target > 0)
    return;
  measured_.rmax = last_period_.rmax;
  measured_.rmax_target = surface.rmax;
}

double chord_error(const Path& path, double s0, double s1, const AxisVector& a,
                   const AxisVector& b) noexcept {
  const auto off = [&](double sample) {
    return distance_to_segment(position(path, s0 + (s1 - s0) * sample / kChordSamples), a, b);
  };
  // The ends belong to the stretch: at a joint within the period they are off the chord as well.
  if (std::holds_alternative<Line>(path)) return std::max(off(0), off(kChordSamples));
  std::array<double, kChordSamples + 1> samples{};
  for (int i = 0; i <= kChordSamples; ++i) samples[static_cast<std::size_t>(i)] = off(i);
  const auto largest = std::max_element(samples.begin(), samples.end());
  if (largest == samples.begin() || largest + 1 == samples.end()) return *largest;
  // Between the samples around it the distance is nearly a parabola.
  const double bend = largest[-1] - 2 * largest[0] + largest[1];
  if (!(bend < 0)) return *largest;
  const double top = 0.5 * (largest[-1] - largest[1]) / bend;
  return std::max(*largest, off(static_cast<double>(largest - samples.begin()) + top));
}

double integrated_length(const Path& path, double s0, double s1) noexcept {
  const auto* nurbs = std::get_if<Nurbs>(&path);
  return nurbs ? integrate(*nurbs, s0, s1) : s1 - s0;
}

}  // namespace softcnc
