// SPDX-License-Identifier: MIT
// Reads a command, checks its numbers, and makes a move of it.
#include "ipr/commands/command_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ipr/codes/transformation.hpp"
#include "ipr/handlers/handlers.hpp"
#include "ipr/state/nearness.hpp"
#include "motion/core/units.hpp"
#include "motion/geometry/spline.hpp"

namespace softcnc::ipr {
namespace {

using FieldKind = CommandField::Kind;

constexpr double kLeastFeed = 1e-6;  // mm/min

constexpr std::array kRows{
    CommandRow{CommandRow::Kind::line, "l", 2, 3, "dx dy [dz]", "a straight line"},
    CommandRow{CommandRow::Kind::arc_by_center, "pcw", 4, 4, "dx dy cx cy",
               "an arc clockwise to a point about a centre"},
    CommandRow{CommandRow::Kind::arc_by_center, "pccw", 4, 4, "dx dy cx cy",
               "the same counter-clockwise"},
    CommandRow{CommandRow::Kind::arc_by_degrees, "dcw", 3, 3, "start end radius",
               "an arc clockwise from an angle to an angle"},
    CommandRow{CommandRow::Kind::arc_by_degrees, "dcaw", 3, 3, "start end radius",
               "the same counter-clockwise"},
    CommandRow{CommandRow::Kind::spline, "s", 1, 1 + 2 * kMaxSplinePoints, "n dx dy ...",
               "a spline through n points"},
    CommandRow{CommandRow::Kind::tangents, "t", 4, 4, "dx dy dx dy",
               "directions at both ends of the next spline; 0 0: natural"},
    CommandRow{CommandRow::Kind::feed, "f", 1, 1, "mm/min", "the feed from here on"},
};

/// Earlier versions called `dcaw` by the name of `pccw`.
constexpr std::string_view kFormerName = "dccw", kItsName = "dcaw";

bool is_counter_clockwise(std::string_view name) {
  return name == kItsName || name.ends_with("ccw");
}

const CommandRow* find_row(std::string_view name) {
  if (name == kFormerName) name = kItsName;
  const auto* row = std::find_if(kRows.begin(), kRows.end(),
                                 [&](const CommandRow& one) { return one.name == name; });
  return row == kRows.end() ? nullptr : row;
}

std::string plural(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Exact at every quarter.
AxisVector direction(double degrees) {
  const double angle = std::fmod(std::fmod(degrees, kFullTurn) + kFullTurn, kFullTurn);
  if (angle == 0) return {1, 0, 0};
  if (angle == kFullTurn / 4) return {0, 1, 0};
  if (angle == kFullTurn / 2) return {-1, 0, 0};
  if (angle == 3 * kFullTurn / 4) return {0, -1, 0};
  const double radians = rad_from_deg(angle);
  return {std::cos(radians), std::sin(radians), 0};
}

}  // namespace

std::span<const CommandRow> command_table() noexcept { return kRows; }

bool CommandFile::read_on() {
  reader_.do_not_wait();
  while (!ended_ && !block_) {
    const auto text = reader_.next();
    if (reader_.waiting()) return false;
    if (text) {
      text_ = *text;
      line_ = reader_.line();
      read_line();
    } else {
      finish();
    }
  }
  return block_.has_value();
}

std::optional<Block> CommandFile::take() {
  block_->number = ++blocks_;
  return std::exchange(block_, std::nullopt);
}

void CommandFile::read_line() {
  if (!is_readable() || !split()) {
    spline_.reset();  // a part of it may be on this line
    pass_numbers_ = true;
    feed_reported_ = feed_reported_ || row_ == nullptr || row_->kind == CommandRow::Kind::feed;
  } else if (head_.kind == FieldKind::name) {
    read_command();
  } else if (numbers_.empty() || pass_numbers_) {
    return;
  } else if (spline_) {
    add_to_spline(numbers_);
  } else {
    report(Code::SC1051, pos_of(numbers_.front()), "numbers without a command before them");
    pass_numbers_ = true;
  }
}

bool CommandFile::is_readable() {
  const auto encoding = line_ == 1 ? wide_encoding(text_) : std::string_view{};
  if (!encoding.empty()) {
    text_ = {};  // nothing that could be shown
    TextError error = wide_error(encoding);
    report(error.code, {1, 1, 1}, std::move(error.message));
    finish();
    return false;
  }
  if (!reader_.line_was_cut()) return true;
  report(Code::SC1015, {line_, 1, 1},
         "the line is longer than " + std::to_string(Reader::kLongestLine) + " bytes");
  return false;
}

/// The line as a name and numbers; false, after a report, if it is not that.
bool CommandFile::split() {
  head_ = {};
  numbers_.clear();
  countable_ = true;
  bool good = true;
  CommandLine fields(text_);
  for (CommandField field = fields.next(); field.kind != FieldKind::end; field = fields.next()) {
    good = take(std::move(field)) && good;
    if (head_.kind == FieldKind::name && row_ == nullptr) return false;  // the rest is no command's
  }
  if (!good && countable_ && head_.kind == FieldKind::name) has_its_numbers(*row_);
  return good;
}

/// False, after a report, if it is none of a line, or out of its place.
bool CommandFile::take(CommandField&& field) {
  if (field.kind == FieldKind::name) return take_name(std::move(field));
  if (field.kind == FieldKind::error && !field.stands_for_number) {
    report_stray(field.error.code, field, std::move(field.error.message));
    return false;
  }
  const bool good = field.kind == FieldKind::number;
  if (!good) {
    countable_ = countable_ && field.error.code != Code::SC1002;  // `-o0`: what follows is of it
    report(field.error.code, pos_of(field), std::move(field.error.message));
  }
  numbers_.push_back(std::move(field));
  return good;
}

bool CommandFile::take_name(CommandField&& name) {
  if (head_.kind == FieldKind::end && numbers_.empty()) {
    head_ = std::move(name);
    const bool may_be_point = find_row(head_.name) == nullptr && stands_for_digit(head_);
    if (spline_ && !may_be_point) leave_spline(in_quotes(head_.name) + " too early");
    return is_known();
  }
  report_stray(Code::SC1053, name, in_quotes(name.name) + " within a line; a command begins one");
  return false;
}

/// What is no number is reported once a line: it may be a text.
void CommandFile::report_stray(Code code, const CommandField& field, std::string message) {
  if (countable_ || code == Code::SC1009) report(code, pos_of(field), std::move(message));
  countable_ = false;
}

/// `J0` among the points of a spline, for 10: a letter right before a number.
bool CommandFile::stands_for_digit(const CommandField& name) const noexcept {
  const auto after = static_cast<std::size_t>(name.column + name.length) - 1;
  return name.length == 1 && after < text_.size() && is_digit(text_[after]);
}

bool CommandFile::is_known() {
  row_ = find_row(head_.name);
  if (row_ == nullptr)
    report(Code::SC1050, pos_of(head_),
           in_quotes(head_.name) + " is no command; there are l, pcw, pccw, dcw, dcaw, s, t and f");
  return row_ != nullptr;
}

void CommandFile::read_command() {
  pass_numbers_ = !has_its_numbers(*row_);
  feed_reported_ = feed_reported_ || (pass_numbers_ && row_->kind == CommandRow::Kind::feed);
  if (!pass_numbers_) act(row_->kind);
}

bool CommandFile::has_its_numbers(const CommandRow& row) {
  if (numbers_.size() >= row.least && numbers_.size() <= row.most) return true;
  const std::string takes = row.least == row.most ? plural(row.least, "number")
                            : row.kind == CommandRow::Kind::spline
                                ? "a number and points"
                                : std::to_string(row.least) + " to " + plural(row.most, "number");
  const bool many = numbers_.size() > row.most;
  report(Code::SC1052, many ? pos_of(numbers_[row.most]) : whole(),
         std::string(row.name) + " takes " + takes + ", " + std::string(row.numbers) + "; here " +
             (numbers_.size() == 1 ? "is " : "are ") + std::to_string(numbers_.size()));
  return false;
}

void CommandFile::act(CommandRow::Kind kind) {
  switch (kind) {
    case CommandRow::Kind::line:
      return line();
    case CommandRow::Kind::arc_by_center:
      return arc_by_center();
    case CommandRow::Kind::arc_by_degrees:
      return arc_by_degrees();
    case CommandRow::Kind::spline:
      return begin_spline();
    case CommandRow::Kind::tangents:
      return set_tangents();
    case CommandRow::Kind::feed:
      return set_feed();
  }
}

void CommandFile::line() {
  AxisVector step = step_at(0);
  if (numbers_.size() > 2) step.z() = number(2);
  if (!has_axes(step) || step.lpNorm<Eigen::Infinity>() < kShortestMove) return;
  if (is_near_enough(position_ + step, whole())) move(softcnc::Line(position_, position_ + step));
}

void CommandFile::arc_by_center() { arc(position_ + step_at(0), position_ + step_at(2), 0); }

/// Table 6 names the degrees of both ends; they leave the radius open, which therefore follows.
void CommandFile::arc_by_degrees() {
  bool good = true;
  for (std::size_t i = 0; i < 2; ++i) {
    if (std::abs(number(i)) <= kFullTurn) continue;
    report(Code::SC2007, pos_of(numbers_[i]), "an angle is given as -360 to 360 degrees");
    good = false;
  }
  const double radius = number(2);
  if (radius <= 0)
    report(Code::SC2007, pos_of(numbers_[2]), "the radius of an arc must be above 0");
  if (!good || radius <= 0) return;
  double sweep = number(1) - number(0);
  if (!is_counter_clockwise(head_.name)) sweep = -sweep;
  while (sweep <= 0) sweep += kFullTurn;
  const AxisVector center = position_ - radius * direction(number(0));
  arc(center + radius * direction(number(1)), center, sweep > kFullTurn ? 1 : 0);
}

void CommandFile::arc(const AxisVector& to, const AxisVector& center, int turns) {
  if (!has_axes({1, 1, 0}) || !is_near_enough(to, whole())) return;
  const bool ccw = is_counter_clockwise(head_.name);
  Result<Arc> made = Arc::make({position_, to, center, Plane::xy, ccw, turns});
  if (made) return move(std::move(*made));
  std::string& message = made.error().message;
  const std::string code = ccw ? "G03" : "G02";
  if (const std::size_t at = message.find(code); at != std::string::npos)
    message.replace(at, code.size(), head_.name);
  report(made.error().code, whole(), std::move(message));
}

void CommandFile::move(Path path) {
  const double feed = cutting_feed();
  position_ = softcnc::end(path);
  const SourcePos source = spline_ ? spline_->pos : pos_of(head_);
  if (!lost_) block_ = Block{Move{std::move(path), false, feed}, source, 0};
}

void CommandFile::set_feed() {
  const double feed = mm_s_from_mm_min(number(0));
  if (feed <= 0) {
    feed_reported_ = true;  // that there is none is a consequence
    return report(Code::SC2007, pos_of(numbers_[0]), "f, the feed in mm/min, must be above 0");
  }
  if (feed < mm_s_from_mm_min(kLeastFeed)) {
    feed_reported_ = true;
    return report(Code::SC2007, pos_of(numbers_[0]), "a feed below 0.000001 mm/min");
  }
  const double limit = machine_.limits.feed;
  feed_ = limit > 0 ? std::min(feed, limit) : feed;
  if (feed_ < feed && !std::exchange(limit_reported_, true))
    report(Code::SC2201, pos_of(numbers_[0]), above_limit("f " + number_text(number(0)), limit));
}

/// The paper's input has no feed: without f the machine's largest is meant, and that is reported.
double CommandFile::cutting_feed() {
  if (feed_ > 0) return feed_;
  double largest = machine_.limits.feed;
  if (largest <= 0)
    for (const Axis& axis : machine_.axes)
      if (axis.present) largest = largest > 0 ? std::min(largest, axis.velocity) : axis.velocity;
  if (!std::exchange(feed_reported_, true)) {
    const std::string message = "no f before it: the machine's " +
                                number_text(mm_min_from_mm_s(largest)) +
                                " mm/min is used from here on";
    spline_ ? report(Code::SC2352, spline_->pos, message, spline_->text)
            : report(Code::SC2352, pos_of(head_), message);
  }
  return largest;
}

/// False, after a report, where a place lies too far off to compute with.
bool CommandFile::is_near_enough(const AxisVector& place, SourcePos pos) {
  if (is_near(place)) return true;
  report(Code::SC3008, pos, leads_far(spline_ ? spline_->head.name : head_.name));
  return false;
}

/// False, after a report, where a step asks for an axis that is not there.
bool CommandFile::has_axes(const AxisVector& step) {
  for (int i = 0; i < kAxes; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    if (step[i] == 0 || machine_.axes[axis].present) continue;
    report(Code::SC2008, whole(), std::string("the machine has no axis ") + kAxisLetters[axis]);
    return false;
  }
  return true;
}

// Splines -----------------------------------------------------------------------------------------

void CommandFile::begin_spline() {
  const double count = number(0);
  if (count < 1 || count != std::floor(count) || count > kMaxSplinePoints) {
    report(Code::SC2007, pos_of(numbers_[0]),
           "s takes the number of its points first, 1 to " + std::to_string(kMaxSplinePoints));
  } else if (has_axes({1, 1, 0})) {
    spline_.emplace();
    spline_->head = head_;
    spline_->pos = pos_of(head_);
    spline_->text = text_;
    spline_->count = static_cast<std::size_t>(count);
    spline_->points.push_back(position_);
    return add_to_spline(std::span(numbers_).subspan(1));
  }
  pass_numbers_ = true;
}

/// They count for one spline.
void CommandFile::set_tangents() {
  const auto direction = [this](std::size_t i) {
    const AxisVector given = step_at(i);
    return given.norm() > 0 ? std::optional(given) : std::nullopt;
  };
  if (has_axes({1, 1, 0})) ends_ = {direction(0), direction(2)};
}

void CommandFile::add_to_spline(std::span<const CommandField> numbers) {
  for (const CommandField& number : numbers) {
    if (spline_ && spline_->given < 2 * spline_->count) {
      add_coordinate(number);
      continue;
    }
    if (!pass_numbers_)
      report(Code::SC2353, pos_of(number), "a number after the last point of the spline");
    pass_numbers_ = true;
    break;
  }
  if (spline_ && spline_->given == 2 * spline_->count) finish_spline();
}

void CommandFile::add_coordinate(const CommandField& number) {
  const SourcePos pos = pos_of(number);
  if (spline_->given++ % 2 == 0) {
    spline_->x = number.value;
    spline_->x_pos = pos;
    return;
  }
  SourcePos both = pos;
  if (spline_->x_pos.line == pos.line)
    both = {pos.line, spline_->x_pos.column, pos.column + pos.length - spline_->x_pos.column};
  add_point({spline_->x, number.value, 0}, both);
}

/// The first point may be the position itself, or left out.
void CommandFile::add_point(const AxisVector& step, SourcePos pos) {
  auto& points = spline_->points;
  const AxisVector point = points.back() + step;
  if (!is_near_enough(point, pos)) return;
  if (step.norm() >= kSplineSamePoint)
    points.push_back(point);
  else if (spline_->given > 2)
    report(Code::SC2351, pos, "a point of the spline is the same as the point before it");
}

void CommandFile::finish_spline() {
  auto spec =
      cubic_spline(spline_->points, machine_.program.spline_parameter, std::exchange(ends_, {}));
  auto made = std::move(spec).and_then(&Nurbs::make);
  if (made)
    move(std::move(*made));
  else if (!lost_)
    report(made.error().code, spline_->pos, std::move(made.error().message), spline_->text);
  spline_.reset();
}

/// Something else where points are still to come.
void CommandFile::leave_spline(const std::string& how) {
  report(Code::SC2353, spline_->pos,
         how + ": the spline has " + std::to_string(spline_->given / 2) + " of its " +
             plural(spline_->count, "point"),
         spline_->text);
  spline_.reset();
}

// Ends and places ---------------------------------------------------------------------------------

void CommandFile::finish() {
  if (reader_.failure()) diagnostics_.report(*reader_.failure());
  if (spline_) leave_spline("the file ends");
  block_ = Block{Action{Action::Kind::end, 30, 0}, {line_, 1, 1}, 0};
  ended_ = true;
}

SourcePos CommandFile::pos_of(const CommandField& field) const noexcept {
  return {line_, field.column, field.length};
}

/// From the name to the last number.
SourcePos CommandFile::whole() const noexcept {
  const CommandField& last = numbers_.empty() ? head_ : numbers_.back();
  return {line_, head_.column, last.column + last.length - head_.column};
}

void CommandFile::report(Code code, SourcePos pos, std::string message) {
  report(code, pos, std::move(message), text_);
}

void CommandFile::report(Code code, SourcePos pos, std::string message, std::string_view text) {
  if (code_info(code).severity == Severity::error) lost_ = true;
  diagnostics_.report(code, pos, std::move(message), text);
}

}  // namespace softcnc::ipr
