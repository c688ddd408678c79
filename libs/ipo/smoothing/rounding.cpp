// SPDX-License-Identifier: MIT
#include "ipo/smoothing/rounding.hpp"
#include "ipo/tuning.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace softcnc::ipo {
namespace {

/// A cubic polynomial about `origin`.
struct Cubic {
  double origin;
  std::array<AxisVector, 4> c;

  /// Returns its blossom: the control point of three knots.
  AxisVector blossom(const double* knots) const {
    const double x = knots[0] - origin, y = knots[1] - origin, z = knots[2] - origin;
    return c[0] + (x + y + z) / 3 * c[1] + (x * y + y * z + z * x) / 3 * c[2] + x * y * z * c[3];
  }
};

/// Adds the difference that the turn makes between the polyline and the curve: a cubic on each side
/// of the peak.
void add(Cubic& cubic, const Turn& turn) {
  const double side = cubic.origin < turn.peak ? 1 : -1;
  const double edge = side > 0 ? turn.begin : turn.end;
  const double e = side * (cubic.origin - edge);
  const AxisVector k =
      turn.tangent_jump / (3 * (turn.end - turn.begin) * side * (turn.peak - edge));
  cubic.c[0] += e * e * e * k;
  cubic.c[1] += side * 3 * e * e * k;
  cubic.c[2] += 3 * e * k;
  cubic.c[3] += side * k;
  const bool is_past_peak = side < 0, is_past_turn = cubic.origin >= turn.t;
  if (is_past_peak == is_past_turn) return;
  const double sign = is_past_peak ? 1 : -1;
  cubic.c[0] += sign * (cubic.origin - turn.t) * turn.tangent_jump;
  cubic.c[1] += sign * turn.tangent_jump;
}

/// Returns the curve between two neighbouring knots.
Cubic piece(std::span<const PolylineEdge> edges, std::span<const Turn> turns, double t0,
            double t1) {
  const double middle = 0.5 * (t0 + t1);
  const PolylineEdge* edge = edges.data();
  while (edge + 1 < edges.data() + edges.size() && edge[1].t <= middle) ++edge;
  Cubic cubic{middle, {}};
  cubic.c = {edge->point + (middle - edge->t) * edge->direction, edge->direction,
             AxisVector::Zero(), AxisVector::Zero()};
  for (const Turn& turn : turns)
    if (turn.begin < middle && middle < turn.end) add(cubic, turn);
  return cubic;
}

/// Returns t0 and t1, and between them where a basis function begins, peaks or ends.
std::vector<double> knots_between(std::span<const Turn> turns, double t0, double t1) {
  std::vector<double> knots{t0};
  for (const Turn& turn : turns)
    for (const double t : {turn.begin, turn.peak, turn.end})
      if (t > t0 + tuning::knots::kSamePlace && t < t1 - tuning::knots::kSamePlace)
        knots.push_back(t);
  std::sort(knots.begin(), knots.end());
  const auto same = [](double a, double b) { return b - a < tuning::knots::kSamePlace; };
  knots.erase(std::unique(knots.begin(), knots.end(), same), knots.end());
  knots.push_back(t1);
  return knots;
}

}  // namespace

Turn spread_evenly(double t, const AxisVector& tangent_jump, double width) {
  return {t, tangent_jump, t - width, t, t + width};
}

double rounding(double distance, double width) noexcept {
  const double inside = width - std::abs(distance);
  return inside > 0 ? inside * inside * inside / (6 * width * width) : 0;
}

NurbsSpec rounded(std::span<const PolylineEdge> edges, std::span<const Turn> turns, double t0,
                  double t1) {
  const std::vector<double> inner = knots_between(turns, t0, t1);
  NurbsSpec spec{3, {}, {}, {}};
  spec.knots.assign(3, t0);
  spec.knots.insert(spec.knots.end(), inner.begin(), inner.end());
  spec.knots.insert(spec.knots.end(), 3, t1);
  const std::size_t spans = inner.size() - 1;
  // A control point belongs to four spans, any of which determines it; the first and last three
  // knots are at the ends.
  for (std::size_t span = 0; span < spans; ++span) {
    const Cubic cubic = piece(edges, turns, inner[span], inner[span + 1]);
    const std::size_t first = span == 0 ? 0 : span + 1;
    const std::size_t last = span + 1 == spans ? span + 3 : span + 1;
    for (std::size_t j = first; j <= last; ++j)
      spec.control.push_back(cubic.blossom(spec.knots.data() + j + 1));
  }
  spec.weights.assign(spec.control.size(), 1.0);
  for (double& knot : spec.knots) knot -= t0;
  return spec;
}

}  // namespace softcnc::ipo
