// SPDX-License-Identifier: MIT
// A place on a curve that is made of smooth spans.
#pragma once

namespace softcnc {

/// A parameter 0 <= t <= 1 inside span 0, 1, 2, ... It is stored as the distance from one end of
/// the span, t = end + offset, so that it is as exact near t = 1 as it is near t = 0.
struct SpanPlace {
  int span = 0;
  int end = 0;        // 0 or 1
  double offset = 0;  // 0 .. 1 after end 0, -1 .. 0 before end 1

  constexpr double from_first() const noexcept { return end == 0 ? offset : 1.0 + offset; }
  constexpr double from_last() const noexcept { return end == 0 ? 1.0 - offset : -offset; }
};

/// t of b minus t of a, in one span.
constexpr double distance(const SpanPlace& a, const SpanPlace& b) noexcept {
  return static_cast<double>(b.end - a.end) + (b.offset - a.offset);
}

constexpr bool operator<(const SpanPlace& a, const SpanPlace& b) noexcept {
  return a.span != b.span ? a.span < b.span : distance(a, b) > 0.0;
}

/// The place where t is the larger by `step`, not beyond the span.
constexpr SpanPlace moved(const SpanPlace& place, double step) noexcept {
  const double t = place.from_first() + step;
  if (t <= 0.0) return {place.span, 0, 0.0};
  if (t >= 1.0) return {place.span, 1, 0.0};
  return {place.span, place.end, place.offset + step};
}

}  // namespace softcnc
