// SPDX-License-Identifier: MIT
// The map between the parameter of a curve and its arc length: built once, evaluated in bounded
// time.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "motion/geometry/chebyshev.hpp"
#include "motion/geometry/curve.hpp"
#include "motion/geometry/span_place.hpp"

namespace softcnc {

/// s(t) and its inverse t(s) as Chebyshev polynomials over cells, which are halved until both are
/// exact: the inverse within kTolerance of the length everywhere, s(t) within that in sum.
class ArcLengthMap {
 public:
  static constexpr double kTolerance = 1e-13;

  /// |dC/dt| in mm; smooth inside a span except where it is zero.
  using Speed = std::function<double(const SpanPlace&)>;

  ArcLengthMap() = default;

  /// Measures a curve of `spans` spans. Returns nothing where the speed is not finite, zero
  /// throughout, or too rugged to be measured.
  static std::optional<ArcLengthMap> measure(const Speed& speed, int spans);

  double length() const noexcept { return starts_.back(); }

  /// 0 <= s <= length(). Where s begins a cell exactly, `side` says which of the two it means.
  SpanPlace place(double s, Side side = Side::after) const noexcept;
  double arc_length(const SpanPlace& place) const noexcept;

  /// Returns the arc length at which each span begins, and the length at the end.
  std::span<const double> span_starts() const noexcept { return span_starts_; }

  /// Where cells had to be shorter than kCrowded of the length, ascending: the curve stands still
  /// there, or nearly so.
  struct Crowd {
    SpanPlace first;
    double width;  // in t
  };
  static constexpr double kCrowded = 1e-10;
  std::vector<Crowd> crowds() const;

 private:
  class Builder;

  static constexpr int kTerms = 16;
  struct Cell {
    SpanPlace first;
    double width;                            // in t
    ChebyshevIntegral<kTerms> s_from_first;  // mm, by t
    ChebyshevSeries<kTerms> t_from_first;    // by s
    std::size_t s_terms, t_terms;            // how many of these matter
  };

  std::vector<double> starts_{0.0};  // of the cells, strictly ascending, and the length
  std::vector<Cell> cells_;
  std::vector<double> span_starts_;
};

}  // namespace softcnc
