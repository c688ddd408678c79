// SPDX-License-Identifier: MIT
// A rounding has its centre where the parallels of both moves meet at its radius.
#include "ipr/corners/corner_piece.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "ipr/text/number.hpp"
#include "motion/core/diagnostic.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kStraightOn = std::numbers::pi / 180;  // rad: FANUC's one degree

/// Where the piece meets a move, and how much it takes off it, as a part of the whole.
struct CornerCut {
  PlaneVector at;
  double part = 0;
};

struct CornerCuts {
  CornerCut before, after;
  std::optional<PlaneVector> center;  // of a rounding
};

double turn_between(const PlaneCurve& before, const PlaneCurve& after) {
  const PlaneVector arriving = before.end_direction(), leaving = after.start_direction();
  return std::atan2(cross(arriving, leaving), arriving.dot(leaving));
}

std::string mm(double length) { return number_text(length) + " mm"; }

std::string lengths_of(const PlaneCurve& before, const PlaneCurve& after) {
  return mm(before.length()) + " and " + mm(after.length());
}

std::string why_no_rounding(const PlaneCurve& before, const PlaneCurve& after, double radius) {
  const double half = std::abs(turn_between(before, after)) / 2;
  if (before.is_arc() || after.is_arc() || std::cos(half) < kLeastRemainder)
    return "no arc of radius " + mm(radius) + " touches both moves, which are " +
           lengths_of(before, after) + " long";
  return "a rounding of radius " + mm(radius) + " takes " + mm(radius * std::tan(half)) +
         " off both moves, which are " + lengths_of(before, after) + " long";
}

std::string why_no_chamfer(const PlaneCurve& before, const PlaneCurve& after, double distance) {
  return "a chamfer of " + mm(distance) + " does not fit on both moves, which are " +
         lengths_of(before, after) + " long";
}

tl::unexpected<Diagnostic> does_not_fit(std::string message) {
  return tl::make_unexpected(Diagnostic{.code = Code::SC2265, .message = std::move(message)});
}

/// The point of a curve, of this radius if it is an arc, next to one on its parallel.
PlaneVector foot(const PlaneCurve& curve, const PlaneVector& beside, double radius) {
  if (curve.is_arc()) return curve.center() + (beside - curve.center()).normalized() * radius;
  const PlaneVector along = curve.end_direction();
  return curve.from() + along * along.dot(beside - curve.from());
}

std::optional<CornerCuts> cuts_of_rounding(const PlaneCurve& before, const PlaneCurve& after,
                                           double radius) {
  const double left = std::copysign(radius, turn_between(before, after));
  const auto beside = before.parallel(left), beyond = after.parallel(left);
  const auto center = beside && beyond ? meeting(*beside, *beyond) : std::nullopt;
  if (!center) return std::nullopt;
  return CornerCuts{
      {foot(before, center->at, before.end_radius()), center->cut_before / beside->length()},
      {foot(after, center->at, after.start_radius()), center->cut_after / beyond->length()},
      center->at};
}

PlaneVector turned_by(const PlaneVector& v, double angle) {
  const double cosine = std::cos(angle), sine = std::sin(angle);
  return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

/// The point of a curve at a straight distance from its end (way -1) or from its start (1); nothing
/// if the curve does not go so far.
std::optional<CornerCut> cut_at(const PlaneCurve& curve, double distance, int way) {
  const PlaneVector corner = way < 0 ? curve.to() : curve.from();
  const double most = 1 + kLeastRemainder / curve.length();
  if (!curve.is_arc()) {
    const CornerCut cut{corner + way * distance * curve.end_direction(), distance / curve.length()};
    return cut.part <= most ? std::optional(cut) : std::nullopt;
  }
  const PlaneVector radial = corner - curve.center();
  if (distance > 2 * radial.norm()) return std::nullopt;
  const double angle = 2 * std::asin(distance / (2 * radial.norm()));
  const CornerCut cut{curve.center() + turned_by(radial, way * std::copysign(angle, curve.sweep())),
                      angle / std::abs(curve.sweep())};
  return cut.part <= most ? std::optional(cut) : std::nullopt;
}

std::optional<CornerCuts> cuts_of_chamfer(const PlaneCurve& before, const PlaneCurve& after,
                                          double distance) {
  const auto first = cut_at(before, distance, -1), second = cut_at(after, distance, 1);
  if (!first || !second) return std::nullopt;
  return CornerCuts{*first, *second, std::nullopt};
}

AxisVector in_space(const PlaneVector& point, const AxisVector& like, const PlaneAxes& axes) {
  AxisVector place = like;
  place[axes.first] = point.x();
  place[axes.second] = point.y();
  return place;
}

Result<Path> arc_between(const AxisVector& from, const AxisVector& to, const AxisVector& center,
                         Plane plane, double sweep) {
  ArcSpec spec{from, to, center, plane, sweep > 0, 0};
  spec.turns = static_cast<int>(std::ceil(std::abs(sweep) / kTurn)) - 1;
  spec.radius_tolerance = std::numeric_limits<double>::infinity();  // the moves are accepted
  Result<Arc> made = Arc::make(spec);
  if (!made) return tl::make_unexpected(std::move(made.error()));
  return Path(std::move(*made));
}

/// What is left of a move from one of its points to another, `part` of it being cut off.
Result<Path> rest_of(const Path& path, const AxisVector& from, const AxisVector& to, double part) {
  const auto* arc = std::get_if<Arc>(&path);
  if (arc == nullptr) return Path(softcnc::Line(from, to));
  return arc_between(from, to, arc->center(), arc->plane(), (1 - part) * arc->sweep());
}

bool is_all(const CornerCut& cut, const PlaneCurve& curve) {
  return (1 - cut.part) * curve.length() < kLeastRemainder;
}

}  // namespace

Result<PiecedCorner> piece_corner(const Path& before, const Path& after, Plane plane,
                                  const CornerPiece& piece) {
  const PlaneAxes axes = plane_axes(plane);
  const PlaneCurve first = plane_curve(before, axes), second = plane_curve(after, axes);
  const double turn = turn_between(first, second);
  if (std::abs(turn) <= kStraightOn) return PiecedCorner{before, std::nullopt, after};
  const auto cuts = piece.round ? cuts_of_rounding(first, second, piece.size)
                                : cuts_of_chamfer(first, second, piece.size);
  if (!cuts)
    return does_not_fit(piece.round ? why_no_rounding(first, second, piece.size)
                                    : why_no_chamfer(first, second, piece.size));
  const bool no_first = is_all(cuts->before, first), no_second = is_all(cuts->after, second);
  const AxisVector start = softcnc::start(before), end = softcnc::end(after);
  const AxisVector from = no_first ? start : in_space(cuts->before.at, start, axes);
  const AxisVector to = no_second ? end : in_space(cuts->after.at, end, axes);
  if ((to - from).norm() < kLeastRemainder)
    return does_not_fit("the second move leads back to where the piece would begin");

  PiecedCorner pieced;
  Result<Path> made = Path(softcnc::Line(from, to));
  if (cuts->center)
    made = arc_between(from, to, in_space(*cuts->center, start, axes), plane,
                       std::copysign(1.0, turn));
  if (!made) return tl::make_unexpected(std::move(made.error()));
  pieced.piece = std::move(*made);
  if (!no_first) {
    made = rest_of(before, start, from, cuts->before.part);
    if (!made) return tl::make_unexpected(std::move(made.error()));
    pieced.before = std::move(*made);
  }
  if (!no_second) {
    made = rest_of(after, to, end, cuts->after.part);
    if (!made) return tl::make_unexpected(std::move(made.error()));
    pieced.after = std::move(*made);
  }
  return pieced;
}

}  // namespace softcnc::ipr
