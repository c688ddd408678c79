// SPDX-License-Identifier: MIT
// The recurrences of the arc, and how it is cut into quadrants and octants.
#include "motion/pulses/pulse_arc.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace softcnc {
namespace {

constexpr std::int64_t kPart = PulseArc::kPart;
constexpr std::int64_t kSecondChange = 2 * kPart * kPart;  // of D, per move

/// For squares of parts, which exceed 64 bits from a radius of 2^23 BLU on.
__extension__ using Wide = __int128;

/// The quadrant in which a counter-clockwise move from here goes on.
int quadrant_after(std::int64_t x, std::int64_t y) noexcept {
  if (x > 0 && y >= 0) return 0;
  if (x <= 0 && y > 0) return 1;
  return x < 0 && y <= 0 ? 2 : 3;
}

/// The quadrant in which one has come here.
int quadrant_before(std::int64_t x, std::int64_t y) noexcept {
  if (x >= 0 && y > 0) return 0;
  if (x < 0 && y >= 0) return 1;
  return x <= 0 && y < 0 ? 2 : 3;
}

/// How many quadrants later an arc ends: a whole number of turns more than the least, as fits the
/// sweep.
int quadrants_between(int from, int to, double sweep) noexcept {
  const int least = (to - from + 4) % 4;
  const double quarters = std::abs(sweep) / (std::numbers::pi / 2);
  const auto turns = static_cast<int>(std::lround((quarters - least) / 4));
  return std::max(least + 4 * turns, 0);
}

std::int64_t nearest_on_grid(std::int64_t parts) noexcept {
  return (parts + kPart / 2) >> PulseArc::kPartBits;
}

}  // namespace

ArcPulses::ArcPulses(const PulseArc& arc, PulseMethod method) noexcept
    : arc_(arc), method_(method), turn_(arc.sweep < 0 ? -1 : 1), at_(arc.from) {
  const auto x = [&](const auto& grid) { return grid[0] * kPart - arc.center[0]; };
  const auto y = [&](const auto& grid) { return grid[1] * kPart - arc.center[1]; };
  quadrant_ = quadrant_after(x(arc.from), turn_ * y(arc.from));
  crossings_ = quadrants_between(quadrant_, quadrant_before(x(arc.to), turn_ * y(arc.to)),  //
                                 arc.sweep);
  const auto square = [](std::int64_t a) { return Wide(a) * a; };
  d_ = static_cast<std::int64_t>(square(x(arc.from)) + square(y(arc.from)) - square(arc.radius));
  begin_quadrant();
}

// Quadrants ---------------------------------------------------------------------------------------

void ArcPulses::begin_quadrant() noexcept {
  const bool first_is_inward = quadrant_ % 2 == 0;
  const std::int64_t first = quadrant_ == 0 || quadrant_ == 1 ? -1 : 1;
  const std::int64_t second = quadrant_ == 0 || quadrant_ == 3 ? turn_ : -turn_;
  inward_ = first_is_inward ? side(0, first) : side(1, second);
  outward_ = first_is_inward ? side(1, second) : side(0, first);
  at_ = target();
}

/// Rounding may have put the start of the first quadrant beyond its end: then it moves back.
ArcPulses::Side ArcPulses::side(std::size_t axis, std::int64_t direction) const noexcept {
  const std::int64_t distance = target()[axis] - at_[axis];
  const std::int64_t along = distance * direction >= 0 ? direction : -direction;
  return {axis, along, std::abs(distance), arc_.radius - 1, Step(arc_.axes[axis], along)};
}

std::array<std::int64_t, 2> ArcPulses::target() const noexcept {
  if (crossings_ == 0) return arc_.to;
  constexpr int kFirst[] = {0, -1, 0, 1}, kSecond[] = {1, 0, -1, 0};
  return {nearest_on_grid(arc_.center[0] + kFirst[quadrant_] * arc_.radius),
          nearest_on_grid(arc_.center[1] + turn_ * kSecond[quadrant_] * arc_.radius)};
}

/// How far an axis is from the center's coordinate in the direction in which it goes, in parts:
/// negative inward.
std::int64_t ArcPulses::travelled(const Side& side) const noexcept {
  const std::int64_t grid = at_[side.axis] - side.direction * side.left;
  return side.direction * (grid * kPart - arc_.center[side.axis]);
}

/// Of D, by the next move.
std::int64_t ArcPulses::change(const Side& side) const noexcept {
  return kPart * (2 * travelled(side) + kPart);
}

// Runs --------------------------------------------------------------------------------------------

std::size_t ArcPulses::fill(std::span<Step> out) noexcept {
  std::size_t filled = 0;
  while (filled < out.size()) {
    if (inward_.left == 0 && outward_.left == 0) {
      if (crossings_ == 0) break;
      --crossings_;
      quadrant_ = (quadrant_ + 1) % 4;
      begin_quadrant();
      continue;
    }
    filled += run(out.subspan(filled));
  }
  return filled;
}

std::size_t ArcPulses::run(std::span<Step> out) noexcept {
  if (inward_.left == 0) return run_alone(outward_, out);
  if (outward_.left == 0) return run_alone(inward_, out);
  if (method_ == PulseMethod::dda) return run_registers(out);
  // No axis can pass its end within that many clocks.
  const auto safe = static_cast<std::size_t>(std::min(inward_.left, outward_.left));
  out = out.first(std::min(out.size(), safe));
  if (method_ == PulseMethod::sam) return run_stairs(out);
  if (method_ == PulseMethod::dsm) return run_search(out);
  return run_octant(out);
}

std::size_t ArcPulses::run_alone(Side& side, std::span<Step> out) noexcept {
  const auto n = std::min(std::ssize(out), static_cast<std::ptrdiff_t>(side.left));
  std::fill_n(out.begin(), n, side.step);
  d_ += n * change(side) + n * (n - 1) / 2 * kSecondChange;
  side.left -= n;
  return static_cast<std::size_t>(n);
}

std::size_t ArcPulses::run_stairs(std::span<Step> out) noexcept {
  std::int64_t inward = change(inward_), outward = change(outward_);
  for (Step& step : out) {
    const bool outside = d_ > 0;
    step = outside ? inward_.step : outward_.step;
    d_ += outside ? inward : outward;
    (outside ? inward : outward) += kSecondChange;
    --(outside ? inward_ : outward_).left;
  }
  return out.size();
}

/// DSM: the smallest |D| after the three moves.
std::size_t ArcPulses::run_search(std::span<Step> out) noexcept {
  std::int64_t inward = change(inward_), outward = change(outward_);
  for (Step& step : out) {
    const std::int64_t in = std::abs(d_ + inward), aside = std::abs(d_ + outward);
    const std::int64_t both = std::abs(d_ + inward + outward);
    const bool moves_in = std::min(in, both) <= aside;
    const bool moves_out = std::min(aside, both) < in;
    step = Step().with_if(moves_in, inward_.step).with_if(moves_out, outward_.step);
    d_ += (moves_in ? inward : 0) + (moves_out ? outward : 0);
    inward += moves_in ? kSecondChange : 0;
    outward += moves_out ? kSecondChange : 0;
    inward_.left -= moves_in ? 1 : 0;
    outward_.left -= moves_out ? 1 : 0;
  }
  return out.size();
}

/// M_SAM and M_DSM within an octant: one axis leads, the other one moves where it must.
std::size_t ArcPulses::run_octant(std::span<Step> out) noexcept {
  const std::int64_t ahead = -travelled(inward_) - travelled(outward_);
  const bool outward = ahead > 0;
  if (outward) {  // until the inward axis leads: a clock brings that nearer by 2 BLU at most
    const auto clocks = static_cast<std::size_t>((ahead + 2 * kPart - 1) / (2 * kPart));
    out = out.first(std::min(out.size(), clocks));
  }
  Side& lead = outward ? outward_ : inward_;
  Side& other = outward ? inward_ : outward_;
  if (method_ == PulseMethod::m_dsm)
    lead_with<true>(lead, other, outward ? 1 : -1, out);
  else
    lead_with<false>(lead, other, outward ? 1 : -1, out);
  return out.size();
}

/// D and all its changes are taken with the sign by which a positive one requires the other axis to
/// move: outside the circle an inward one, inside an outward one. The nearer of two points is known
/// by the sign of the sum of their D, which lie on different sides of the circle, or else on that
/// from which the other axis leads away.
template <bool nearer>
void ArcPulses::lead_with(Side& lead, Side& other, std::int64_t sign,
                          std::span<Step> out) noexcept {
  const std::int64_t on_circle = nearer || sign > 0 ? 0 : 1;  // M_SAM there moves outward
  const std::int64_t second = sign * kSecondChange;
  std::int64_t d = sign * d_ + on_circle;
  std::int64_t leading = sign * change(lead);
  std::int64_t half = sign * change(other) / 2;
  std::int64_t joined = 0;
  for (Step& step : out) {
    const bool joins = (nearer ? d + leading + half : d) > 0;
    step = lead.step.with_if(joins, other.step);
    d += leading + (joins ? 2 * half : 0);
    leading += second;
    half += joins ? second / 2 : 0;
    joined += joins ? 1 : 0;
  }
  d_ = sign * (d - on_circle);
  lead.left -= std::ssize(out);
  other.left -= joined;
}

/// DDA: each register takes the other axis' coordinate; an overflow is a pulse.
std::size_t ArcPulses::run_registers(std::span<Step> out) noexcept {
  std::size_t clocks = 0;
  while (clocks < out.size() && inward_.left > 0 && outward_.left > 0) {
    const std::int64_t in = std::max<std::int64_t>(-travelled(inward_), 0);
    const std::int64_t across = std::max<std::int64_t>(travelled(outward_), 0);
    const bool moves_in = take(inward_, across), moves_out = take(outward_, in);
    out[clocks++] = Step().with_if(moves_in, inward_.step).with_if(moves_out, outward_.step);
  }
  return clocks;
}

bool ArcPulses::take(Side& side, std::int64_t amount) const noexcept {
  side.over += amount;
  if (side.over < arc_.radius) return false;
  side.over -= arc_.radius;
  --side.left;
  return true;
}

}  // namespace softcnc
