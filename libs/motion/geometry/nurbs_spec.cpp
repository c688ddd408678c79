// SPDX-License-Identifier: MIT
#include "motion/geometry/nurbs_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "motion/geometry/bezier.hpp"

namespace softcnc {
namespace {

tl::unexpected<Diagnostic> refusal(Code code, std::string message) {
  return tl::unexpected(Diagnostic{code, {}, std::move(message), {}, {}});
}

Status check_counts(const NurbsSpec& spec) {
  const int order = spec.degree + 1;
  if (spec.degree < 1 || spec.degree > kMaxBezierDegree)
    return refusal(Code::SC3001, fmt::format("a NURBS of order {}; orders 2 to {} are supported",
                                             order, kMaxBezierDegree + 1));
  const auto points = std::ssize(spec.control);
  if (points < order)
    return refusal(
        Code::SC3002,
        fmt::format("{} control points are too few for a NURBS of order {}", points, order));
  if (std::ssize(spec.knots) != points + order)
    return refusal(Code::SC3003,
                   fmt::format("{} knots for {} control points of order {}: there must be {}",
                               spec.knots.size(), points, order, points + order));
  if (std::ssize(spec.weights) != points)
    return refusal(Code::SC3007,
                   fmt::format("{} weights for {} control points", spec.weights.size(), points));
  return {};
}

Status check_numbers(const NurbsSpec& spec) {
  for (std::size_t i = 0; i < spec.control.size(); ++i) {
    if (!spec.control[i].allFinite())
      return refusal(Code::SC3008, fmt::format("control point {} is not finite", i + 1));
    if (!std::isfinite(spec.weights[i]) || spec.weights[i] <= 0)
      return refusal(Code::SC3007, fmt::format("weight {} of control point {} is not positive",
                                               spec.weights[i], i + 1));
  }
  for (std::size_t i = 0; i < spec.knots.size(); ++i)
    if (!std::isfinite(spec.knots[i]))
      return refusal(Code::SC3008, fmt::format("knot {} is not finite", i + 1));
  return {};
}

Status check_order_of_knots(const std::vector<double>& knots) {
  const auto falls = std::adjacent_find(knots.begin(), knots.end(), std::greater<>{});
  if (falls == knots.end()) return {};
  return refusal(Code::SC3004, fmt::format("knot {} ({}) is less than the knot before it ({})",
                                           falls - knots.begin() + 2, falls[1], falls[0]));
}

Status check_ends(const NurbsSpec& spec) {
  const auto order = static_cast<std::size_t>(spec.degree) + 1;
  const auto& knots = spec.knots;
  if (knots[0] != knots[order - 1])
    return refusal(Code::SC3005, fmt::format("the first {} knots are not equal ({} to {})", order,
                                             knots[0], knots[order - 1]));
  if (knots[knots.size() - order] != knots.back())
    return refusal(Code::SC3005, fmt::format("the last {} knots are not equal ({} to {})", order,
                                             knots[knots.size() - order], knots.back()));
  return {};
}

Status check_continuity(const NurbsSpec& spec) {
  const auto order = static_cast<std::size_t>(spec.degree) + 1;
  const auto& knots = spec.knots;
  for (std::size_t i = 1; i + order < knots.size(); ++i)
    if (knots[i] == knots[i + order - 1])
      return refusal(
          Code::SC3006,
          fmt::format("knot {} ({}) occurs {} times: a curve of order {} would be discontinuous",
                      i + 1, knots[i], std::count(knots.begin(), knots.end(), knots[i]), order));
  return {};
}

Status check_extent(const NurbsSpec& spec) {
  const auto& first = spec.control.front();
  const auto differs = [&](const AxisVector& point) { return point != first; };
  if (std::any_of(spec.control.begin(), spec.control.end(), differs)) return {};
  return refusal(Code::SC3009, "all control points of the NURBS are the same");
}

}  // namespace

Status check(const NurbsSpec& spec) {
  return check_counts(spec)
      .and_then([&] { return check_numbers(spec); })
      .and_then([&] { return check_order_of_knots(spec.knots); })
      .and_then([&] { return check_ends(spec); })
      .and_then([&] { return check_continuity(spec); })
      .and_then([&] { return check_extent(spec); });
}

}  // namespace softcnc
