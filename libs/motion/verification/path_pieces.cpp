// SPDX-License-Identifier: MIT
#include "motion/verification/path_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace softcnc {
namespace {

constexpr double kShortestPiece = 1e-6;  // mm: shorter ones are as good as points
constexpr double kLeastTurn = 0.5;       // cosine of the largest turn in a piece
constexpr double kRestOfPiece = 0.1;     // of a piece: what is left after it and is added to it
constexpr double kProbe = 0.4;  // where a cubic is compared with the curve, as a part of it
constexpr int kPieceSteps = 8;
constexpr double kLastPieceStep = 1e-7;  // mm
constexpr double kSame = 1e-5;           // mm
constexpr double kSwing = 5e-3;          // mm: two steps of a coarse encoder

AxisVector value(const CubicPiece& piece, double x) noexcept {
  return piece.q + x * (piece.c1 + x * (piece.c2 + x * piece.c3));
}

/// A cubic lies in the hull of its Bezier points.
double furthest_from_chord(const CubicPiece& piece) noexcept {
  const AxisVector first = piece.q + piece.c1 / 3;
  const AxisVector second = first + (piece.c1 + piece.c2) / 3;
  return std::max(distance_to_segment(first, piece.q, piece.end),
                  distance_to_segment(second, piece.q, piece.end));
}

CubicPiece hermite(const PathPoint& a, const PathPoint& b, double s0, double s1,
                   const PathOrigin& origin) noexcept {
  const double h = s1 - s0;
  const AxisVector chord = b.q - a.q;
  CubicPiece piece{
      s0,  s1, a.q,   h * a.dq, 3 * chord - h * (2 * a.dq + b.dq), h * (a.dq + b.dq) - 2 * chord,
      b.q, 0,  origin};
  piece.slack = furthest_from_chord(piece);
  return piece;
}

/// A circle of this curvature (1/mm) leaves its cubic by h^4 / (384 r^3).
double fitting_length(double curvature, double longest) noexcept {
  if (!(curvature > 0)) return longest;
  return std::min(longest,
                  std::sqrt(std::sqrt(384 * CubicPiece::kTolerance * curvature)) / curvature);
}

/// Makes cubics of a part of a path without a jump of a derivative inside, each as long as
/// possible.
class SmoothPart {
 public:
  SmoothPart(const Portion& part, double offset, const PathOrigin& origin) noexcept
      : part_(part), offset_(offset), origin_(origin) {}

  /// Every try is shorter than the one before: a rest that a step may take along is at most
  /// kRestOfPiece of it, less than what a try that does not fit takes off, and no try is much below
  /// kShortestPiece.
  void append_to(std::vector<CubicPiece>& pieces) {
    double s = part_.s0;
    PathPoint here = at(*part_.path, s, Side::after);
    double step = std::max(kShortestPiece, fitting_length(here.ddq.norm(), part_.s1 - s));
    while (s < part_.s1) {
      const double rest = part_.s1 - s - step;
      const double next =
          rest < std::min(kShortestPiece, kRestOfPiece * step) ? part_.s1 : s + step;
      const PathPoint there = at(*part_.path, next, Side::before);
      const CubicPiece piece = hermite(here, there, s + offset_, next + offset_, origin_);
      const double growth = growth_of(piece, here, there);
      step = std::max(growth * (next - s), kShortestPiece);
      if (!fits_ && next - s > (1 + 2 * kRestOfPiece) * kShortestPiece) continue;
      pieces.push_back(piece);
      s = next;
      here = there;
    }
  }

 private:
  /// Returns by how much the next one may be longer; sets fits_.
  double growth_of(const CubicPiece& piece, const PathPoint& a, const PathPoint& b) noexcept {
    constexpr double kCareful = 0.85, kLeast = 0.2, kMost = 2.0;
    const double s = piece.s0 - offset_ + kProbe * piece.length();
    const double off = (position(*part_.path, s) - value(piece, kProbe)).norm();
    const bool turns = a.dq.dot(b.dq) < kLeastTurn;
    fits_ = off <= CubicPiece::kTolerance && !turns;
    if (turns) return 0.5;
    if (off == 0) return kMost;
    return std::clamp(kCareful * std::sqrt(std::sqrt(CubicPiece::kTolerance / off)), kLeast, kMost);
  }

  Portion part_;
  double offset_;  // mm: from the path to the program
  PathOrigin origin_;
  bool fits_ = false;
};

/// The part of the piece nearest to the point, by Newton's method from the nearest point of the
/// chord.
double nearest_part(const CubicPiece& piece, const AxisVector& point, double low,
                    double high) noexcept {
  const AxisVector chord = piece.end - piece.q;
  const double square = std::max(chord.squaredNorm(), std::numeric_limits<double>::min());
  double x = std::clamp((point - piece.q).dot(chord) / square, low, high);
  const double enough = kLastPieceStep / piece.length();
  for (int i = 0; i < kPieceSteps; ++i) {
    const AxisVector off = value(piece, x) - point;
    const AxisVector slope = piece.c1 + x * (2 * piece.c2 + 3 * x * piece.c3);
    const AxisVector second = 2 * piece.c2 + 6 * x * piece.c3;
    const double speed = slope.squaredNorm();
    if (!(speed > 0)) break;
    const double next =
        std::clamp(x - slope.dot(off) / std::max(speed + second.dot(off), 0.5 * speed), low, high);
    const double step = std::abs(next - x);
    x = next;
    if (step <= enough) break;
  }
  return x;
}

/// The distance of a point from the path at s; where the path there is ahead of the point by less
/// than kSwing, from its tangent.
double beside(const CubicPiece& piece, double s, const AxisVector& point) noexcept {
  const double x = (s - piece.s0) / piece.length();
  const AxisVector off = value(piece, x) - point;
  const AxisVector slope = piece.c1 + x * (2 * piece.c2 + 3 * x * piece.c3);
  const double ahead = off.dot(slope.normalized());
  const double distance = off.norm();
  if (!(ahead > 0 && ahead < kSwing)) return distance;
  return std::sqrt(std::max(distance * distance - ahead * ahead, 0.0));
}

bool may_be_nearer(const CubicPiece& piece, const AxisVector& point, double than) noexcept {
  const AxisVector chord = piece.end - piece.q;
  const AxisVector off = point - piece.q;
  const double square = chord.squaredNorm();
  const double part = square > 0 ? std::clamp(off.dot(chord) / square, 0.0, 1.0) : 0.0;
  const double range = than + piece.slack;
  return range > 0 && (off - part * chord).squaredNorm() < range * range;
}

}  // namespace

AxisVector CubicPiece::position(double s) const noexcept {
  return value(*this, (s - s0) / length());
}

CubicPiece CubicPiece::until(double s) const noexcept {
  const double part = (s - s0) / length();
  CubicPiece piece = *this;
  piece.end = position(s);
  piece.c1 *= part;
  piece.c2 *= part * part;
  piece.c3 *= part * part * part;
  piece.s1 = s;
  piece.slack = furthest_from_chord(piece);
  return piece;
}

double angle_between(const AxisVector& a, const AxisVector& b) noexcept {
  return 2 * std::asin(std::min((a - b).norm() / 2, 1.0));
}

void append_pieces(const Portion& portion, double s_start, const PathOrigin& origin,
                   std::vector<CubicPiece>& pieces) {
  const auto& [path, s0, s1] = portion;
  if (!(s1 > s0)) return;
  const double offset = s_start - s0;
  if (std::holds_alternative<Line>(*path)) {
    pieces.push_back(hermite(at(*path, s0), at(*path, s1), s_start, s1 + offset, origin));
    return;
  }
  double begin = s0;
  const auto inner = breaks(*path);
  for (auto next = std::upper_bound(inner.begin(), inner.end(), s0);
       next != inner.end() && *next < s1; ++next) {
    SmoothPart({path, begin, *next}, offset, origin).append_to(pieces);
    begin = *next;
  }
  SmoothPart({path, begin, s1}, offset, origin).append_to(pieces);
}

void PathPieces::append(std::span<const CubicPiece> pieces) {
  pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
}

void PathPieces::cut(double s) {
  while (!empty() && pieces_.back().s0 >= s) pieces_.pop_back();
  if (!empty() && pieces_.back().s1 > s) pieces_.back() = pieces_.back().until(s);
}

void PathPieces::forget(double s) noexcept {
  constexpr std::size_t kMany = 1024;
  while (first_ + 1 < pieces_.size() && pieces_[first_].s1 <= s) ++first_;
  if (first_ < kMany || 2 * first_ < pieces_.size()) return;
  pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(first_));
  first_ = 0;
}

/// Returns the first piece from that index on which ends beyond s: in steps that double, then by
/// bisection.
std::size_t PathPieces::beyond(double s, std::size_t from) const noexcept {
  std::size_t step = 1, high = from;
  while (high < pieces_.size() && pieces_[high].s1 <= s) {
    from = high + 1;
    high += step;
    step *= 2;
  }
  high = std::min(high, pieces_.size());
  const auto begin = pieces_.begin();
  return static_cast<std::size_t>(
      std::partition_point(begin + static_cast<std::ptrdiff_t>(from),
                           begin + static_cast<std::ptrdiff_t>(high),
                           [s](const CubicPiece& piece) { return piece.s1 <= s; }) -
      begin);
}

/// A point of the path is nearer than another one by at most the path between them. So from a piece
/// whose end is further away than the bar by d, the next d of path can be skipped.
///
/// After the first minimum the bar is lower: on a path that comes back the same way, neither
/// rounding nor an encoder that swings back a little must move the tool to the way back too soon.
PathPieces::Nearest PathPieces::nearest(const AxisVector& point, double from, double to) noexcept {
  forget(from);
  const CubicPiece& first = pieces_[first_];
  from = std::clamp(from, first.s0, first.s1);
  Nearest best{from, (first.position(from) - point).norm(), first.origin};
  double bar = best.distance;
  bool descends = true;
  const auto offer = [&](const CubicPiece& piece, double s, double distance) {
    if (!(distance < bar)) return;
    best = {s, distance, piece.origin};
    bar = descends ? distance : distance - kSame;
  };
  for (std::size_t i = first_; i < pieces_.size() && pieces_[i].s0 <= to;) {
    const CubicPiece& piece = pieces_[i];
    if (may_be_nearer(piece, point, bar)) {
      const double low = std::max(from - piece.s0, 0.0) / piece.length();
      const double high = std::min((to - piece.s0) / piece.length(), 1.0);
      const double x = nearest_part(piece, point, std::min(low, high), high);
      offer(piece, piece.s0 + x * piece.length(), (value(piece, x) - point).norm());
      if (high < 1) offer(piece, to, (value(piece, high) - point).norm());
    }
    const double off = (piece.end - point).norm();
    if (piece.s1 <= to) offer(piece, piece.s1, off);
    if (std::exchange(descends, descends && best.s >= piece.s1) && !descends)
      bar = (best.s > from ? best.distance : beside(first, from, point)) - kSame;
    i = beyond(piece.s1 + std::max(off - bar, 0.0), i + 1);
  }
  if (best.s == from) best.distance = beside(first, from, point);
  return best;
}

double PathPieces::turn(double from, double to) const noexcept {
  double sum = 0;
  const CubicPiece* before = nullptr;
  for (std::size_t i = first_; i < pieces_.size() && pieces_[i].s0 < to; ++i) {
    const CubicPiece& piece = pieces_[i];
    if (piece.s1 <= from) continue;
    const double part = (std::min(to, piece.s1) - std::max(from, piece.s0)) / piece.length();
    sum += part * angle_between(piece.start_direction(), piece.end_direction());
    if (before) sum += angle_between(before->end_direction(), piece.start_direction());
    before = &piece;
  }
  return sum;
}

}  // namespace softcnc
