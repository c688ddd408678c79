// SPDX-License-Identifier: MIT
#include "runtime/sinks/curve_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "motion/core/units.hpp"
#include "motion/roughness/roughness.hpp"

namespace softcnc::runtime {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180 / std::numbers::pi;

/// A point of a path, and what is asked of the surface there.
struct Place {
  const Path* path;
  double s;  // mm from the start of the path
  const Surface* surface;

  PathPoint point() const { return at(*path, s); }
};

std::optional<Place> place_of(const Setpoint& row, std::span<const PathStretch> stretches) {
  if (stretches.empty()) return std::nullopt;
  const PathStretch& here = stretch_at(stretches, row.s);
  return Place{here.path, std::clamp(row.s - here.s_start, 0.0, length(*here.path)), here.surface};
}

/// Lines and arcs run from 0 to 1.
double parameter(const Place& place) {
  const auto* nurbs = std::get_if<Nurbs>(place.path);
  return nurbs ? nurbs->parameter(place.s) : place.s / length(*place.path);
}

double feed_per_tooth(const Surface& surface, double v) {
  return surface.tooth_rate() > 0 ? v / surface.tooth_rate() : 0;
}

double value_on_path(CurveColumn column, const Place& place, const Setpoint& row,
                     const MeasuredPeriod& period) {
  switch (column) {
    case CurveColumn::parameter:
      return parameter(place);
    case CurveColumn::curvature:
      return place.point().ddq.norm();
    case CurveColumn::chord_error:
      return um_from_mm(period.chord_error);
    case CurveColumn::feed_fluctuation:
      return period.feed_fluctuation;
    case CurveColumn::inclination:
      return place.surface ? kDegrees * std::asin(std::min(inclination_sine(place.point().dq), 1.0))
                           : kNone;
    case CurveColumn::feed_per_tooth:
      return place.surface ? feed_per_tooth(*place.surface, row.v) : kNone;
    case CurveColumn::rmax:
      return place.surface ? um_from_mm(period.rmax) : kNone;
  }
  return kNone;
}

bool counts_without_path(CurveColumn column) {
  return column == CurveColumn::curvature || column == CurveColumn::chord_error ||
         column == CurveColumn::feed_fluctuation;
}

}  // namespace

std::vector<CurveColumn> all_curve_columns() {
  std::vector<CurveColumn> columns;
  for (std::size_t i = 0; i < kCurveColumnNames.size(); ++i)
    columns.push_back(static_cast<CurveColumn>(i));
  return columns;
}

CurveColumns::CurveColumns(std::vector<CurveColumn> columns)
    : columns_(std::move(columns)), sums_(columns_.size()) {}

std::vector<std::string> CurveColumns::names() const {
  std::vector<std::string> names;
  for (const CurveColumn column : columns_) names.emplace_back(name(column));
  return names;
}

void CurveColumns::observe(const ObservedRow& observed) {
  const Setpoint& row = observed.row;
  const auto place = place_of(row, observed.stretches);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double value = place ? value_on_path(columns_[i], *place, row, observed.period)
                         : counts_without_path(columns_[i]) ? 0
                                                            : kNone;
    waiting_.push_back(value);
    if (std::isnan(value) || !(row.advance > 0)) continue;
    Sums& sums = sums_[i];
    sums.max = std::max(sums.max, std::abs(value));
    sums.sum += std::abs(value);
    sums.squares += value * value;
    ++sums.rows;
  }
}

void CurveColumns::take(std::vector<double>& values) {
  const auto end = waiting_.begin() + static_cast<std::ptrdiff_t>(columns_.size());
  values.insert(values.end(), waiting_.begin(), end);
  waiting_.erase(waiting_.begin(), end);
}

std::vector<ColumnFigures> CurveColumns::figures() const {
  std::vector<ColumnFigures> figures;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const Sums& sums = sums_[i];
    ColumnFigures& of_column = figures.emplace_back(ColumnFigures{columns_[i], {}});
    if (sums.rows == 0) continue;
    const auto rows = static_cast<double>(sums.rows);
    of_column.spread = {sums.max, sums.sum / rows, std::sqrt(sums.squares / rows)};
  }
  return figures;
}

}  // namespace softcnc::runtime
