// SPDX-License-Identifier: MIT
// The columns of a trace that are computed from the path of each row, on demand.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/sinks/row_observer.hpp"

namespace softcnc::runtime {

enum class CurveColumn : std::uint8_t {
  parameter,
  curvature,
  chord_error,
  feed_fluctuation,
  inclination,
  feed_per_tooth,
  rmax
};
inline constexpr std::array<std::string_view, 7> kCurveColumnNames{
    "u",          "curvature_1_mm", "chord_error_um", "feed_fluctuation", "inclination_deg",
    "f_tooth_mm", "rmax_um"};
constexpr std::string_view name(CurveColumn column) noexcept {
  return kCurveColumnNames[static_cast<std::size_t>(column)];
}
std::vector<CurveColumn> all_curve_columns();

/// What a column amounts to over the rows that move and where it has a value, of which there may be
/// none. Magnitudes count, whatever the sign of a fluctuation.
struct ColumnFigures {
  struct Spread {
    double max, mean, rms;
  };
  CurveColumn column;
  std::optional<Spread> spread;
};

class CurveColumns final : public RowObserver {
 public:
  explicit CurveColumns(std::vector<CurveColumn> columns);

  std::vector<std::string> names() const;

  /// Adds a row. A column without a meaning there is NaN: the parameter where there is no path, and
  /// the last three where no roughness is asked for.
  void observe(const ObservedRow& observed) override;

  /// Appends the values of the oldest row that has not been taken to `values`.
  void take(std::vector<double>& values);

  std::vector<ColumnFigures> figures() const;

 private:
  struct Sums {
    double max = 0, sum = 0, squares = 0;
    std::int64_t rows = 0;
  };

  std::vector<CurveColumn> columns_;
  std::vector<Sums> sums_;  // by column
  std::deque<double> waiting_;
};

}  // namespace softcnc::runtime
