// SPDX-License-Identifier: MIT
#include "motion/model/contact.hpp"

#include <algorithm>
#include <cmath>

namespace softcnc {
namespace {

constexpr double kTouch = 2e-9;   // mm: as near as this is a contact
constexpr double kDigit = 1e-9;   // mm: to which places of contacts are rounded
constexpr double kClear = 4e-9;   // mm: as far as this is a release, whichever way it is rounded
constexpr double kFound = 1e-12;  // mm: where a bisection ends

/// The distance of a point from a body, mm; 0 within it.
double distance(const ContactBody& body, const AxisVector& point) noexcept {
  const AxisVector nearest = point.cwiseMax(body.min).cwiseMin(body.max);
  return (point - nearest).norm();
}

bool touches(const ContactBody& body, const ProbeTip& tip, const AxisVector& place,
             double near) noexcept {
  return distance(body, tip.center(place)) <= tip.radius + near;
}

/// Bisects for the place between two where touching changes; `a` and `b` are mm along the line.
template <typename Touching>
double change_between(double a, double b, const Touching& touching) noexcept {
  const bool at_b = touching(b);
  for (int i = 0; i < 100 && std::abs(b - a) > kFound; ++i) {
    const double middle = 0.5 * (a + b);
    (touching(middle) == at_b ? b : a) = middle;
  }
  return std::round(b / kDigit) * kDigit;
}

/// Where the line is nearest to a body, mm: the distance from a convex body is convex along a line.
double nearest_place(const Line& line, const ContactBody& body, const ProbeTip& tip) noexcept {
  const auto at = [&](double s) { return distance(body, tip.center(line.position(s))); };
  constexpr double kThird = 1.0 / 3;
  double low = 0, high = line.length();
  for (int i = 0; i < 200 && high - low > kDigit; ++i) {
    const double step = kThird * (high - low);
    const double left = at(low + step), right = at(high - step);
    if (left <= right) high -= step;
    if (right <= left) low += step;
  }
  return 0.5 * (low + high);
}

/// Where the tip first touches a body.
std::optional<double> first_contact(const Line& line, std::span<const ContactBody> bodies,
                                    const ProbeTip& tip) noexcept {
  std::optional<double> first;
  for (const ContactBody& body : bodies) {
    const auto touching = [&](double s) { return touches(body, tip, line.position(s), 0); };
    const double nearest = nearest_place(line, body, tip);
    if (!touching(nearest)) continue;
    const double s = change_between(0, nearest, touching);
    if (!first || s < *first) first = s;
  }
  return first;
}

/// Where the tip touches no body any more: each round leaves one at least, into free space or into
/// the next one.
std::optional<double> first_release(const Line& line, std::span<const ContactBody> bodies,
                                    const ProbeTip& tip) noexcept {
  double released = 0;
  for (std::size_t round = 0; round < bodies.size(); ++round)
    for (const ContactBody& body : bodies) {
      const auto touching = [&](double s) { return touches(body, tip, line.position(s), kClear); };
      if (!touching(released)) continue;
      if (touching(line.length())) return std::nullopt;
      released = change_between(released, line.length(), touching);
    }
  return released;
}

}  // namespace

bool touches(std::span<const ContactBody> bodies, const ProbeTip& tip,
             const AxisVector& place) noexcept {
  return std::any_of(bodies.begin(), bodies.end(),
                     [&](const ContactBody& body) { return touches(body, tip, place, kTouch); });
}

std::optional<double> contact_along(const Line& line, std::span<const ContactBody> bodies,
                                    const ProbeTip& tip, ProbeAim aim) noexcept {
  const bool begins_in_contact = touches(bodies, tip, line.position(0));
  if (begins_in_contact == (aim == ProbeAim::contact)) return std::nullopt;
  return begins_in_contact ? first_release(line, bodies, tip) : first_contact(line, bodies, tip);
}

}  // namespace softcnc
