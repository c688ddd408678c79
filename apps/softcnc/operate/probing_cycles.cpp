// SPDX-License-Identifier: MIT
#include "operate/probing_cycles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "settings/axis_words.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

using Lines = tl::expected<std::string, std::string>;

constexpr double kPlain = 100;             // mm/min: of a face that is probed once
constexpr double kFast = 300, kSlow = 50;  // mm/min: towards a face for the first and second time
constexpr double kAway = 1000;             // mm/min: where nothing is measured
constexpr double kOff = 2;                 // mm: off a face before it is touched again
constexpr double kBeside = 6;              // mm: how far a side may be from where it is expected

/// Lines that a cycle is made of. An axis is its index; distances are in mm.
class Cycle {
 public:
  explicit Cycle(const ProbingStart& start) : start_(start) {}

  /// Moves by a distance, and stops at a contact, where the next touch() is an error.
  Cycle& go(std::size_t axis, double distance) {
    return add(fmt::format("G91 G38.3 {}{:.4f} F{}\nG90", letter(axis), distance, kAway));
  }
  /// Touches a face twice, and moves off it.
  Cycle& touch(std::size_t axis, double reach) {
    const double off = reach > 0 ? -kOff : kOff;
    const char name = letter(axis);
    return add(
        fmt::format("G91 G38.2 {}{:.4f} F{}\nG01 {}{} F{}\nG38.2 {}{} F{}\nG01 {}{} F{}\nG90", name,
                    reach, kFast, name, off, kAway, name, -2 * off, kSlow, name, off, kAway));
  }
  Cycle& go_back(std::size_t axis) {
    return add(fmt::format("G53 G01 {}{:.4f} F{}", letter(axis),
                           start_.place[static_cast<Eigen::Index>(axis)], kAway));
  }
  /// Keeps the coordinate of the last contact, and what is to be added to it.
  Cycle& keep(const char* name, std::size_t axis, double more = 0) {
    return add(fmt::format("#<{}> = [#{} + {:.4f}]", name, 5061 + axis, more));
  }
  Cycle& add(const std::string& line) {
    text_ += line + '\n';
    return *this;
  }
  const std::string& text() const noexcept { return text_; }

 private:
  static char letter(std::size_t axis) { return kAxisLetters[axis]; }

  ProbingStart start_;
  std::string text_ = "G21 G94 G40 G17\n";
};

constexpr const char kToMiddle[] = "G01 {}[[#<probed_low> + #<probed_high>] / 2] F{}";

/// Distances along the axes.
using Sizes = std::array<double, kAxes>;

Lines bore(const Sizes& sizes, const ProbingStart& start) {
  Cycle cycle(start);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double reach = sizes[axis] / 2 + kBeside;
    cycle.touch(axis, -reach).keep("probed_low", axis).go_back(axis);
    cycle.touch(axis, reach).keep("probed_high", axis);
    cycle.add(fmt::format(kToMiddle, kAxisLetters[axis], kAway));
  }
  return cycle.add("G10 L20 P0 X0 Y0").text();
}

/// Down beside it, against its side, and up again.
void touch_side(Cycle& cycle, std::size_t axis, double out, double depth) {
  cycle.go(axis, out).go(2, -depth).touch(axis, out > 0 ? -2 * kBeside : 2 * kBeside);
  cycle.keep(out > 0 ? "probed_high" : "probed_low", axis).go_back(2).go_back(axis);
}

Lines boss(const Sizes& sizes, const ProbingStart& start) {
  Cycle cycle(start);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double out = sizes[axis] / 2 + kBeside + start.radius;
    touch_side(cycle, axis, -out, sizes[2]);
    touch_side(cycle, axis, out, sizes[2]);
    cycle.add(fmt::format(kToMiddle, kAxisLetters[axis], kAway));
  }
  return cycle.add("G10 L20 P0 X0 Y0").text();
}

Lines corner(const Sizes& along, const ProbingStart& start) {
  Cycle cycle(start);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::size_t other = 1 - axis;
    cycle.go(other, along[other]).touch(axis, 2 * along[axis]);
    cycle.keep(axis == 0 ? "probed_x" : "probed_y", axis, std::copysign(start.radius, along[axis]));
    cycle.go_back(axis).go_back(other);
  }
  return cycle.add("G10 L20 P0 X[#5420 - #<probed_x>] Y[#5421 - #<probed_y>]").text();
}

Lines face(std::string_view text, const ProbingStart& start, const Machine& machine) {
  const std::size_t equals = std::min(text.find('='), text.size());
  const AxisWords way = axis_words(words_of(text.substr(0, equals)));
  const auto wanted = equals < text.size() ? parse_mm(text.substr(equals + 1)) : std::nullopt;
  if (!way.wrong.empty() || way.named() != 1 || (equals < text.size() && !wanted))
    return tl::make_unexpected(
        "as Z-20, Z-20=0, bore X30 Y30, boss X60 Y40 Z8 or corner X15 Y15, in mm");
  const auto is_named = [](const auto& mm) { return mm.has_value(); };
  const auto axis = static_cast<std::size_t>(std::find_if(way.mm.begin(), way.mm.end(), is_named) -
                                             way.mm.begin());
  const char letter = kAxisLetters[axis];
  std::string lines =
      fmt::format("G21 G94 G91 G38.2 {}{} F{}\nG90\n", letter, *way.mm[axis], kPlain);
  if (wanted)
    lines +=
        fmt::format("G10 L20 P0 {}[{} + #{} - #{}]\n", letter, *wanted, 5420 + axis, 5061 + axis);
  const Axis& travel = machine.axes[axis];
  const double begin = start.place[static_cast<Eigen::Index>(axis)];
  return lines + fmt::format("G53 G00 {}{}\n", letter, std::clamp(begin, travel.min, travel.max));
}

struct Shape {
  std::string_view name;
  std::size_t axes;  // the first ones, which its text names
  bool may_be_negative;
  Lines (*lines)(const Sizes&, const ProbingStart&);
  const char* example;
};

constexpr Shape kShapes[] = {
    {"bore", 2, false, bore, "bore and its widths in mm, as bore X30 Y30"},
    {"boss", 3, false, boss, "boss, its widths and how deep beside it in mm, as boss X60 Y40 Z8"},
    {"corner", 2, true, corner, "corner and how far along its faces in mm, as corner X15 Y15"},
};

std::optional<Sizes> sizes_of(const Shape& shape, std::span<const std::string> words) {
  const AxisWords named = axis_words(words);
  if (!named.wrong.empty() || named.named() != shape.axes) return std::nullopt;
  Sizes sizes{};
  for (std::size_t axis = 0; axis < shape.axes; ++axis) {
    const auto& mm = named.mm[axis];
    if (!mm || *mm == 0 || (*mm < 0 && !shape.may_be_negative)) return std::nullopt;
    sizes[axis] = *mm;
  }
  return sizes;
}

}  // namespace

tl::expected<std::string, std::string> probing_lines(std::string_view text,
                                                     const ProbingStart& start,
                                                     const Machine& machine) {
  const std::vector<std::string> words = words_of(text);
  for (const Shape& shape : kShapes) {
    if (words.empty() || words.front() != shape.name) continue;
    if (const auto sizes = sizes_of(shape, std::span(words).subspan(1)))
      return shape.lines(*sizes, start);
    return tl::make_unexpected(shape.example);
  }
  return face(text, start, machine);
}

}  // namespace softcnc::app
