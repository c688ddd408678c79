// SPDX-License-Identifier: MIT
// Measures a curve cell by cell: the speed as a Chebyshev series, its integral, and the inverse.
#include "motion/geometry/arc_length.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc {
namespace {

constexpr int kFew = 8;                  // samples that may suffice for a span
constexpr int kMostHalvings = 200;       // halvings of a span
constexpr double kShortestCell = 1e-14;  // of the length: cells below are taken linear
constexpr int kInversionSteps = 8;
constexpr double kTrifle = 0.02;       // of a tolerance: terms that change nothing
constexpr double kSlopeTrifle = 1e-9;  // of the speed: in the slope of Newton's method

std::span<const double> terms(const auto& series) noexcept {
  return {series.data(), static_cast<std::size_t>(series.size())};
}

std::span<const double> without_trifles(const auto& series, double trifle) noexcept {
  return terms(series).first(chebyshev_terms(terms(series), trifle));
}

/// Returns the largest of the last coefficients, even and odd ones: what the polynomial does not
/// follow.
template <int n>
double tail(const Eigen::Array<double, n, 1>& c) noexcept {
  return c.template tail<1 + n / 8>().abs().maxCoeff();
}

/// A cell in -1 <= x <= 1, by n samples: its speed, and how far the curve has come.
template <int n>
struct Forward {
  ChebyshevSeries<n> ds;   // mm per unit of x
  ChebyshevIntegral<n> s;  // mm from the beginning of the cell
  double length;
  double error;  // of s inside the cell, estimated
  double fastest;

  /// Of the length. The rule of quadrature behind it (Fejer's first) converges twice as fast as the
  /// series; half of that advantage is counted on.
  double length_error() const noexcept { return error * std::sqrt(std::min(1.0, error / length)); }
};

/// x(s) as a series in y = 2 s / length - 1, by Newton's method at all nodes together. Trailing
/// terms that change nothing are left out: most of a cell that is nearly straight.
template <int n>
ChebyshevSeries<n> invert(const Forward<n>& forward, double tolerance) {
  using Samples = ChebyshevSamples<n>;
  const auto s_terms = without_trifles(forward.s, kTrifle * tolerance);
  const auto ds_terms = without_trifles(forward.ds, kSlopeTrifle * forward.fastest);
  const Samples s = 0.5 * forward.length * (1.0 + chebyshev_nodes<n>());
  Samples x = chebyshev_nodes<n>();
  for (int i = 0; i < kInversionSteps; ++i) {
    const Samples miss = evaluate_chebyshev(s_terms, x) - s;
    x = (x - miss / evaluate_chebyshev(ds_terms, x)).max(-1.0).min(1.0);
    if ((miss.abs() <= tolerance).all()) break;
  }
  return chebyshev_series(x);
}

/// Returns the largest error in s, evaluated between the nodes, where polynomials through 8 or 16
/// of them deviate most: cos(k pi / 8).
template <int n>
double inverse_error(const Forward<n>& forward, const ChebyshevSeries<n>& x_of_s) noexcept {
  static_assert(n == 8 || n == 16);
  const Eigen::Array4d y(-1.0, -0.38268343236509, 0.70710678118655, 0.92387953251129);
  const Eigen::Array4d x = evaluate_chebyshev(terms(x_of_s), y);
  const Eigen::Array4d s = evaluate_chebyshev(terms(forward.s), x);
  const double miss = (s - 0.5 * forward.length * (1.0 + y)).abs().maxCoeff();
  return std::max(miss, tail(x_of_s) * forward.fastest);
}

}  // namespace

class ArcLengthMap::Builder {
 public:
  Builder(const Speed& speed, int spans)
      : speed_(speed), spans_(spans), most_cells_(4096 + 64 * static_cast<std::size_t>(spans)) {}

  std::optional<ArcLengthMap> build();

 private:
  template <int n>
  Forward<n> forward(const SpanPlace& first, double width) const;
  void cover(const SpanPlace& first, double width, int depth);
  template <int n>
  bool keep_if_exact(const SpanPlace& first, double width, const Forward<n>& forward);
  void keep_linear(const SpanPlace& first, double width, double length);
  static Cell empty_cell(const SpanPlace& first, double width) {
    return {
        first, width, decltype(Cell::s_from_first)::Zero(), decltype(Cell::t_from_first)::Zero(),
        0,     0};
  }
  void keep(const Cell& cell, double length);

  const Speed& speed_;
  int spans_;
  std::size_t most_cells_;
  double scale_ = 0.0;  // mm: the length, estimated
  double carry_ = 0.0;  // of the compensated sum of lengths
  bool failed_ = false;
  ArcLengthMap map_;
};

template <int n>
Forward<n> ArcLengthMap::Builder::forward(const SpanPlace& first, double width) const {
  const auto ds_at = [&](double x) {
    return 0.5 * width * speed_({first.span, first.end, first.offset + 0.5 * width * (1.0 + x)});
  };
  const ChebyshevSamples<n> samples = chebyshev_nodes<n>().unaryExpr(ds_at);
  Forward<n> f;
  f.ds = chebyshev_series(samples);
  f.s = integrate_chebyshev(f.ds);
  f.length = evaluate_chebyshev(terms(f.s), 1.0);
  f.fastest = samples.maxCoeff();
  const double off_first = std::abs(evaluate_chebyshev(terms(f.ds), -1.0) - ds_at(-1.0));
  const double off_last = std::abs(evaluate_chebyshev(terms(f.ds), 1.0) - ds_at(1.0));
  f.error = 0.25 * std::max({tail(f.ds), off_first, off_last});
  return f;
}

std::optional<ArcLengthMap> ArcLengthMap::Builder::build() {
  std::vector<Forward<kFew>> whole_spans;
  whole_spans.reserve(static_cast<std::size_t>(spans_));
  for (int span = 0; span < spans_; ++span) {
    whole_spans.push_back(forward<kFew>({span}, 1.0));
    scale_ += whole_spans.back().length;
  }
  if (!std::isfinite(scale_) || !(scale_ > 0.0)) return std::nullopt;
  for (int span = 0; span < spans_ && !failed_; ++span) {
    map_.span_starts_.push_back(map_.length());
    const Forward<kFew>& whole_span = whole_spans[static_cast<std::size_t>(span)];
    if (!keep_if_exact({span}, 1.0, whole_span)) cover({span}, 1.0, 0);
  }
  map_.span_starts_.push_back(map_.length());
  if (failed_ || map_.cells_.empty()) return std::nullopt;
  return std::move(map_);
}

void ArcLengthMap::Builder::cover(const SpanPlace& first, double width, int depth) {
  const Forward<kTerms> f = forward<kTerms>(first, width);
  if (keep_if_exact(first, width, f)) return;
  if (f.length + f.error <= kShortestCell * scale_) {
    keep_linear(first, width, f.length);
    return;
  }
  const double half = 0.5 * width;
  failed_ = !std::isfinite(f.length) || depth >= kMostHalvings || map_.cells_.size() >= most_cells_;
  SpanPlace middle = first;
  middle.offset += half;
  if (depth == 0) middle = {first.span, 1, -0.5};  // from here on counted from the end
  for (const SpanPlace& begin : {first, middle})
    if (!failed_) cover(begin, half, depth + 1);
}

template <int n>
bool ArcLengthMap::Builder::keep_if_exact(const SpanPlace& first, double width,
                                          const Forward<n>& f) {
  // Errors of the length add up, so that each cell may have its share only.
  const double tolerance = kTolerance * scale_;
  const double share = 0.5 * (kTolerance * f.length + tolerance * width / spans_);
  if (!(f.error <= 0.3 * tolerance && f.length_error() <= share)) return false;
  ChebyshevSeries<n> t = invert(f, 0.1 * tolerance);
  if (!(inverse_error(f, t) <= 0.3 * tolerance)) return false;
  const double trifle = kTrifle * tolerance;
  Cell cell = empty_cell(first, width);
  cell.s_terms = chebyshev_terms(terms(f.s), trifle);
  cell.t_terms = chebyshev_terms(terms(t), trifle / f.fastest);
  t[0] += 1.0;
  cell.s_from_first.head<n + 1>() = f.s;
  cell.t_from_first.head<n>() = 0.5 * width * t;
  keep(cell, f.length);
  return true;
}

void ArcLengthMap::Builder::keep_linear(const SpanPlace& first, double width, double length) {
  Cell cell = empty_cell(first, width);
  cell.s_terms = cell.t_terms = 2;
  cell.s_from_first.head<2>().setConstant(0.5 * length);
  cell.t_from_first.head<2>().setConstant(0.5 * width);
  keep(cell, length);
}

void ArcLengthMap::Builder::keep(const Cell& cell, double length) {
  const double begin = map_.length();
  const double advance = length - carry_;  // Kahan's summation
  const double end = begin + advance;
  if (!(end > begin)) return;  // too short to count
  carry_ = (end - begin) - advance;
  map_.starts_.push_back(end);
  map_.cells_.push_back(cell);
}

std::optional<ArcLengthMap> ArcLengthMap::measure(const Speed& speed, int spans) {
  return Builder(speed, spans).build();
}

SpanPlace ArcLengthMap::place(double s, Side side) const noexcept {
  const auto inner = std::span(starts_).subspan(1, cells_.size() - 1);
  const auto next = side == Side::after ? std::upper_bound(inner.begin(), inner.end(), s)
                                        : std::lower_bound(inner.begin(), inner.end(), s);
  const auto i = static_cast<std::size_t>(next - inner.begin());
  const Cell& cell = cells_[i];
  const double begin = starts_[i];
  const double end = starts_[i + 1];
  if (s <= begin) return cell.first;
  if (s >= end) return moved(cell.first, cell.width);
  const double y = 2.0 * (s - begin) / (end - begin) - 1.0;
  const double t = evaluate_chebyshev(terms(cell.t_from_first).first(cell.t_terms), y);
  return moved(cell.first, std::clamp(t, 0.0, cell.width));
}

double ArcLengthMap::arc_length(const SpanPlace& place) const noexcept {
  const auto before = [](const SpanPlace& a, const Cell& b) { return a < b.first; };
  const auto next = std::upper_bound(cells_.begin() + 1, cells_.end(), place, before);
  const auto i = static_cast<std::size_t>(next - cells_.begin()) - 1;
  const Cell& cell = cells_[i];
  if (!(cell.first < place)) return starts_[i];
  const double x = 2.0 * distance(cell.first, place) / cell.width - 1.0;
  if (place.span > cell.first.span || x >= 1.0) return starts_[i + 1];
  const double s = evaluate_chebyshev(terms(cell.s_from_first).first(cell.s_terms), x);
  return std::clamp(starts_[i] + s, starts_[i], starts_[i + 1]);
}

std::vector<ArcLengthMap::Crowd> ArcLengthMap::crowds() const {
  std::vector<Crowd> crowds;
  bool crowded = false;  // the cell before was short, in the same span
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    const bool is_short = starts_[i + 1] - starts_[i] <= kCrowded * length();
    if (is_short && crowded && crowds.back().first.span == cell.first.span)
      crowds.back().width += cell.width;
    else if (is_short)
      crowds.push_back({cell.first, cell.width});
    crowded = is_short;
  }
  return crowds;
}

}  // namespace softcnc
