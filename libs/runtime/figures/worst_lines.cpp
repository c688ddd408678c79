// SPDX-License-Identifier: MIT
#include "runtime/figures/worst_lines.hpp"

#include <algorithm>

namespace softcnc::runtime {
namespace {

constexpr double kLeastLoss = 1e-9;  // s: less is rounding

/// Hands each part of a span that belongs to one line to sink(mark, span).
template <typename Sink>
void for_each_mark(const ipo::TimedBlock& timed, ipo::Profile::Span span, Sink&& sink) {
  for (const ipo::Mark& mark : timed.marks) {
    if (mark.s <= span.s0) continue;
    if (mark.s >= span.s1) break;
    ipo::Profile::Span before = span;
    before.s1 = span.s0 = mark.s;
    before.t1 = span.t0 = std::clamp(timed.profile.time_at(mark.s), span.t0, span.t1);
    sink(timed.at(before.s0), before);
  }
  sink(timed.at(span.s0), span);
}

}  // namespace

Limit LineLosses::Loss::limit() const noexcept {
  return static_cast<Limit>(std::max_element(parts.begin(), parts.end()) - parts.begin());
}

LineLosses::Loss& LineLosses::at(const SourcePos& place) {
  auto& lines = lines_[place.file];
  const auto index = static_cast<std::size_t>(std::max(place.line, 0));
  if (lines.size() <= index) lines.resize(index + 1);
  return lines[index];
}

void LineLosses::add(const ipo::TimedBlock& timed, double until, double feed_override) {
  const Move* move = timed.move();
  const bool cuts = move != nullptr && !move->rapid;
  const double feed = cuts ? asked_feed(*move, feed_override) : 0;
  timed.profile.for_each_span(until, [&](const ipo::Profile::Span& whole) {
    for_each_mark(timed, whole, [&](const ipo::Mark& mark, const ipo::Profile::Span& span) {
      const double seconds = span.t1 - span.t0;
      Loss& loss = at(mark.source);
      loss.seconds += seconds;
      if (!cuts) return;
      const double lost = seconds - (feed > 0 ? (span.s1 - span.s0) / feed : 0);
      loss.all += lost;
      loss.parts[static_cast<std::size_t>(span.limit)] += static_cast<float>(lost);
    });
  });
}

std::vector<LineTime> LineLosses::times() const {
  std::vector<LineTime> times;
  for (const auto& [file, lines] : lines_)
    for (std::size_t line = 0; line < lines.size(); ++line)
      if (const Loss& loss = lines[line]; loss.seconds > 0)
        times.push_back({file, static_cast<int>(line), loss.seconds, loss.all, loss.limit()});
  return times;
}

std::vector<LineLosses::Place> LineLosses::worst_places(std::size_t count) const {
  std::vector<Place> places;
  for (const auto& [file, lines] : lines_)
    for (std::size_t line = 0; line < lines.size(); ++line)
      if (lines[line].all > kLeastLoss)
        places.push_back({file, static_cast<int>(line), &lines[line]});
  const auto worse = [](const Place& a, const Place& b) {
    if (a.loss->all != b.loss->all) return a.loss->all > b.loss->all;
    return a.file != b.file ? a.file < b.file : a.line < b.line;
  };
  const auto end = places.begin() + static_cast<std::ptrdiff_t>(std::min(count, places.size()));
  std::partial_sort(places.begin(), end, places.end(), worse);
  places.erase(end, places.end());
  return places;
}

}  // namespace softcnc::runtime
