// SPDX-License-Identifier: MIT
#include "ipr/parser/stock_comment.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "ipr/text/number.hpp"
#include "motion/core/units.hpp"

namespace softcnc::ipr {
namespace {

constexpr std::string_view kWord = "WORKPIECE,";
constexpr int kCorners = 36;  // of the polygon that stands for a circle

std::string upper(std::string_view text) {
  std::string result(without_blanks_around(text));
  std::transform(result.begin(), result.end(), result.begin(), upper_case);
  return result;
}

/// Takes what stands before the next comma off the text.
std::string next_part(std::string_view& text) {
  const std::size_t comma = text.find(',');
  const std::string part = upper(text.substr(0, comma));
  text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
  return part;
}

tl::unexpected<Diagnostic> refused(std::string reason) {
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC2388, .message = "the stock cannot be read: " + std::move(reason)});
}

/// The keys and values of a comment; the first thing that is wrong with them is kept.
class StockValues {
 public:
  explicit StockValues(std::string_view text) {
    while (!text.empty()) {
      const std::string part = next_part(text);
      const std::size_t equals = part.find('=');
      if (equals == std::string::npos)
        fail("'" + part + "' is no KEY=VALUE");
      else
        values_[upper(part.substr(0, equals))] = upper(part.substr(equals + 1));
    }
  }

  std::string text(const std::string& key, std::string otherwise) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::move(otherwise) : found->second;
  }

  /// Returns the number of a key; without the key that of `otherwise`, and an error without one.
  double number(const std::string& key, std::optional<double> otherwise = {}) {
    const auto found = values_.find(key);
    if (found == values_.end()) {
      if (!otherwise) fail(key + " is missing");
      return otherwise.value_or(0);
    }
    const Number read = read_number(found->second);
    if (read.error != NumberError::none || read.length != found->second.size())
      fail(key + "=" + found->second + " is no number");
    return read.value;
  }

  void fail(std::string reason) {
    if (failure_.empty()) failure_ = std::move(reason);
  }
  const std::string& failure() const noexcept { return failure_; }

 private:
  std::map<std::string, std::string> values_;
  std::string failure_;
};

struct Span {
  double low, high;
};

Span read_span(StockValues& values, int axis) {
  const std::string letter(1, kAxisLetters[static_cast<std::size_t>(axis)]);
  const Span span{values.number(letter + "MIN"), values.number(letter + "MAX")};
  if (!(span.low < span.high)) values.fail(letter + "MIN is not less than " + letter + "MAX");
  return span;
}

void add_box(StockValues& values, StockOutline& stock) {
  AxisVector low, high;
  for (int axis = 0; axis < kAxes; ++axis) {
    const Span span = read_span(values, axis);
    low[axis] = span.low;
    high[axis] = span.high;
  }
  for (int axis = 0; axis < kAxes; ++axis)
    for (int corner = 0; corner < 4; ++corner) {  // one for each of the four parallel edges
      AxisVector from = low, to = low;
      const int first = (axis + 1) % kAxes, second = (axis + 2) % kAxes;
      if ((corner & 1) != 0) from[first] = high[first];
      if ((corner & 2) != 0) from[second] = high[second];
      to = from;
      to[axis] = high[axis];
      stock.edges.emplace_back(from, to);
    }
}

void add_circle(const AxisVector& centre, int axis, double radius, StockOutline& stock) {
  const auto corner = [&](int i) {
    const double angle = 2 * std::numbers::pi * (i % kCorners) / kCorners;
    AxisVector point = centre;
    point[(axis + 1) % kAxes] += radius * std::cos(angle);
    point[(axis + 2) % kAxes] += radius * std::sin(angle);
    return point;
  };
  for (int i = 0; i < kCorners; ++i) stock.edges.emplace_back(corner(i), corner(i + 1));
}

double read_diameter(StockValues& values, const std::string& key) {
  const double diameter = values.number(key);
  if (!(diameter > 0)) values.fail(key + " is not above 0");
  return diameter;
}

void add_round(StockValues& values, StockOutline& stock) {
  const std::string letter = values.text("AXIS", "Z");
  const int axis = letter.size() == 1 ? axis_index(letter.front()) : -1;
  if (axis < 0) return values.fail("AXIS is X, Y or Z");
  const Span span = read_span(values, axis);
  AxisVector low;
  for (int i = 0; i < kAxes; ++i)
    low[i] = i == axis
                 ? span.low
                 : values.number(std::string(1, kAxisLetters[static_cast<std::size_t>(i)]), 0);
  AxisVector high = low;
  high[axis] = span.high;
  const double outer = read_diameter(values, "DIAMETER");
  add_circle(low, axis, outer / 2, stock);
  add_circle(high, axis, outer / 2, stock);
  constexpr int kSides = 4;
  for (int i = 0; i < kSides; ++i) {
    const std::size_t at = static_cast<std::size_t>(i * kCorners / kSides);
    stock.edges.emplace_back(stock.edges[at].first, stock.edges[at + kCorners].first);
  }
  if (stock.shape != StockShape::tube) return;
  const double inner = read_diameter(values, "INNER_DIAMETER");
  if (!(inner < outer)) values.fail("INNER_DIAMETER is not less than DIAMETER");
  add_circle(low, axis, inner / 2, stock);
  add_circle(high, axis, inner / 2, stock);
}

}  // namespace

bool states_stock(std::string_view comment) noexcept {
  const std::string_view said = without_blanks_around(comment);
  return said.size() >= kWord.size() && said.find('=') != std::string_view::npos &&
         std::equal(kWord.begin(), kWord.end(), said.begin(),
                    [](char wanted, char c) { return wanted == upper_case(c); });
}

Result<StockOutline> read_stock(std::string_view comment, double mm_per_unit) {
  std::string_view rest = without_blanks_around(comment).substr(kWord.size());
  const std::string shape = next_part(rest);
  StockOutline stock;
  if (shape != "BOX" && shape != "CYLINDER" && shape != "TUBE")
    return refused("'" + shape + "' is none of BOX, CYLINDER and TUBE");
  if (shape != "BOX") stock.shape = shape == "TUBE" ? StockShape::tube : StockShape::cylinder;
  StockValues values(rest);
  const std::string units = values.text("UNITS", "");
  if (units == "MM") mm_per_unit = 1;
  if (units == "INCH") mm_per_unit = kMmPerInch;
  if (!units.empty() && units != "MM" && units != "INCH") values.fail("UNITS is MM or INCH");
  stock.shape == StockShape::box ? add_box(values, stock) : add_round(values, stock);
  if (!values.failure().empty()) return refused(values.failure());
  for (auto& [from, to] : stock.edges) {
    from *= mm_per_unit;
    to *= mm_per_unit;
  }
  return stock;
}

}  // namespace softcnc::ipr
