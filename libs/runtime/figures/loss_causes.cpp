// SPDX-License-Identifier: MIT
#include "runtime/figures/loss_causes.hpp"

#include <algorithm>
#include <cmath>

#include "ipo/tuning.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kLeastOfCause = 1e-9;  // s: less is rounding
constexpr double kSameSpeed = 1e-9;     // mm/s
constexpr double kCornerAngle = 1e-3;   // rad: less turns no corner
constexpr double kReversing = 0.5;      // of the speed, that a reversing axis has before and after
constexpr double kPlace = 1e-3;         // mm: places this near are one
constexpr std::size_t kFewPlaces = 3;   // more need not be told apart

}  // namespace

LossCauses::Parts LossCauses::parts_of(const ipo::TimedBlock& timed, double until, double feed) {
  using Span = ipo::Profile::Span;
  std::vector<Span> spans;
  timed.profile.for_each_span(until, [&](const Span& span) { spans.push_back(span); });
  const auto lost = [&](const Span& span) {
    return span.t1 - span.t0 - (feed > 0 ? (span.s1 - span.s0) / feed : 0);
  };
  Parts parts;
  if (spans.empty()) return parts;
  parts.first = spans.front().limit;
  parts.last = spans.back().limit;
  std::size_t begin = 0, end = spans.size();
  while (begin < end && spans[begin].v1 > spans[begin].v0 + kSameSpeed)
    parts.head += lost(spans[begin++]);
  while (end > begin && spans[end - 1].v0 > spans[end - 1].v1 + kSameSpeed)
    parts.tail += lost(spans[--end]);
  for (; begin < end; ++begin)
    parts.middle[static_cast<std::size_t>(spans[begin].limit)] += lost(spans[begin]);
  return parts;
}

void LossCauses::add(const ipo::TimedBlock& timed, double until, double feed_override) {
  const Move* move = timed.move();
  if (move == nullptr || move->rapid) return close();
  const Parts parts = parts_of(timed, until, asked_feed(*move, feed_override));
  const double end = length(move->path);
  if (open_.cuts)
    pass_joint(at(move->path, 0).dq, parts);
  else
    count(LossKind::rest, -1, Limit::feed, parts.head);
  for (std::size_t i = 0; i < parts.middle.size(); ++i)
    count(LossKind::curve, -1, static_cast<Limit>(i), parts.middle[i]);
  const PathPoint last = at(move->path, end, Side::before);
  open_ = {true,    parts.tail, last.q,
           last.dq, parts.last, timed.profile.end_speed() <= ipo::tuning::path::kStandstill};
}

/// The move before ends at rest.
void LossCauses::close() {
  if (open_.cuts) count(LossKind::rest, -1, Limit::feed, open_.tail);
  open_ = {};
}

void LossCauses::pass_joint(const AxisVector& direction, const Parts& parts) {
  const AxisVector change = direction - open_.direction;
  const double lost = open_.tail + parts.head;
  if (change.norm() < kCornerAngle) {
    if (open_.at_rest) return count(LossKind::rest, -1, Limit::feed, lost);
    count(LossKind::curve, -1, open_.limit, open_.tail);
    return count(LossKind::curve, -1, parts.first, parts.head);
  }
  int axis = 0;
  change.cwiseAbs().maxCoeff(&axis);
  const double in = open_.direction[axis], out = direction[axis];
  const bool reverses = in * out < 0 && std::min(std::abs(in), std::abs(out)) >= kReversing;
  count(reverses ? LossKind::reversal : LossKind::corner, axis, Limit::feed, lost, open_.end[axis]);
}

void LossCauses::count(LossKind kind, int axis, Limit limit, double lost, double place) {
  if (std::abs(lost) < kLeastOfCause) return;
  auto sum = std::find_if(sums_.begin(), sums_.end(), [&](const Sum& one) {
    return one.cause.kind == kind && one.cause.axis == axis && one.cause.limit == limit;
  });
  place = std::round(place / kPlace) * kPlace + 0.0;  // no -0
  if (sum == sums_.end())
    sum = sums_.insert(sums_.end(), Sum{{kind, axis, limit, 0, 0, place, place, true}, {}});
  LossCause& cause = sum->cause;
  ++cause.count;
  cause.lost += lost;
  cause.from = std::min(cause.from, place);
  cause.to = std::max(cause.to, place);
  if (sum->places.size() < kFewPlaces) sum->places.insert(place);
  cause.only_ends = sum->places.size() < kFewPlaces;
}

std::vector<LossCause> LossCauses::causes() const {
  LossCauses whole = *this;
  whole.close();
  std::vector<LossCause> causes;
  for (const Sum& sum : whole.sums_) causes.push_back(sum.cause);
  std::stable_sort(causes.begin(), causes.end(),
                   [](const LossCause& a, const LossCause& b) { return a.lost > b.lost; });
  return causes;
}

}  // namespace softcnc::runtime
