// SPDX-License-Identifier: MIT
// G12 and G13, Haas' circular pocket: half circles lead out and back, full circles cut. Haas' mill
// operator's manual, "G12 Circular Pocket Milling CW / G13 Circular Pocket Milling CCW".
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "ipr/codes/code_numbers.hpp"
#include "ipr/handlers/handlers.hpp"

namespace softcnc::ipr {
namespace {

constexpr double kMostPasses = 1e4;   // of one line: its moves are made at once
constexpr double kSameRadius = 1e-9;  // mm

/// What a line asks for, in mm.
struct Pocket {
  double first = 0, last = 0, step = 0;  // radii of the tool's passes
  int loops = 1;
  bool ccw = false;
};

bool refuse_value(Task& task, char letter, std::string_view must) {
  report_word(task, letter, Code::SC2007, std::string(1, letter) + ", " + std::string(must));
  return false;
}

bool has_pocket_words(Task& task) {
  if (!has_word(task, 'I', "the radius of the first pass") || !has_word(task, 'Z', "the depth"))
    return false;
  if (task.values.has('K') && !has_word(task, 'Q', "the steps of the radius from I to K"))
    return false;
  if (task.values.has('Q') && !has_word(task, 'K', "the radius of the last pass")) return false;
  if (task.values.value_or('Q', 1) > 0) return true;
  return refuse_value(task, 'Q', "the step of the radius, must be above 0");
}

std::string too_small(const Task& task, char letter, double radius, double tool) {
  return std::string(1, letter) + number_text(task.values[letter]) + " is a radius of " +
         number_text(radius) + " mm, and that of the tool is " + number_text(tool) + " mm";
}

/// The radii of the pocket less that of the tool.
bool fits_tool(Task& task, const Pocket& pocket, double tool) {
  if (pocket.first <= kSameRadius) {
    report_word(task, 'I', Code::SC2267, too_small(task, 'I', pocket.first + tool, tool));
    return false;
  }
  if (pocket.last > pocket.first || !task.values.has('K')) return true;
  report_word(task, 'K', Code::SC2267,
              "K" + number_text(task.values['K']) + " is not larger than I" +
                  number_text(task.values['I']));
  return false;
}

std::optional<int> loops_of(Task& task) {
  if (!task.values.has('L')) return 1;
  const auto loops = whole_number(task, task.values.word('L'));
  if (!loops || *loops > 0) return loops;
  refuse_value(task, 'L', "how often the pocket is cut, must be at least 1");
  return std::nullopt;
}

/// By which G51 makes the pocket, and not the tool, larger. Nothing, after a report, where the
/// pocket would not be a circle in X Y.
std::optional<double> scale_of_pocket(Task& task) {
  const Transformation& transformation = task.modal.transformation;
  if (transformation.rotation && task.modal.plane != Plane::xy) {
    task.out.report(Code::SC2251, task.word.pos,
                    code_name(task.code) + " while G68 turns another plane than X Y");
    return std::nullopt;
  }
  if (const auto scale = transformation.scale(plane_axes(Plane::xy))) return scale;
  task.out.report(Code::SC2256, task.word.pos,
                  code_name(task.code) + " is no circle under different scales of X and Y");
  return std::nullopt;
}

std::optional<Pocket> pocket_of(Task& task) {
  if (!has_pocket_words(task) || !has_near_lengths(task, "IKQ")) return std::nullopt;
  const auto scale = scale_of_pocket(task);
  if (!scale) return std::nullopt;
  const auto loops = loops_of(task);
  auto tool = loops ? radius_of_pocket_tool(task) : std::nullopt;
  if (!tool) return std::nullopt;
  *tool /= *scale;
  const double unit = task.modal.mm_per_unit;
  Pocket pocket;
  pocket.first = task.values['I'] * unit - *tool;
  pocket.last = task.values.value_or('K', task.values['I']) * unit - *tool;
  pocket.step = task.values.value_or('Q', 0) * unit;
  pocket.loops = *loops;
  pocket.ccw = task.code.number == kG13;
  if (!fits_tool(task, pocket, *tool)) return std::nullopt;
  const double passes = pocket.step > 0 ? (pocket.last - pocket.first) / pocket.step + 1 : 1;
  if (passes * pocket.loops <= kMostPasses) return pocket;
  task.out.report(Code::SC2007, task.word.pos,
                  code_name(task.code) + " on this line would take more than 10000 passes");
  return std::nullopt;
}

/// The tool on its path. Places are in coordinates of the program, `out` is what it is to the right
/// of the centre, along X.
class PocketPath {
 public:
  PocketPath(Task& task, const Pocket& pocket, const AxisVector& center)
      : task_(task), pocket_(pocket), center_(center) {}

  int blocks() const { return blocks_; }

  void plunge(double z) {
    center_[2] = z;
    const AxisVector to = task_.modal.coordinates.to_machine(center_);
    if (!is_near(to)) return report_far();
    move_straight(task_, to, false);
    ++blocks_;
  }

  /// Passes from the innermost to the outermost, each begun where the half circle to it ends.
  void cut() {
    double radius = pocket_.first;
    half_circle(0, radius);
    for (double out = radius;;) {
      circle(out, out);
      if (pocket_.last - radius < kSameRadius) return half_circle(out, 0);
      radius = std::min(radius + pocket_.step, pocket_.last);
      half_circle(out, std::copysign(radius, -out));
      out = std::copysign(radius, -out);
    }
  }

 private:
  AxisVector at(double out) const {
    AxisVector place = center_;
    place[0] += out;
    return task_.modal.coordinates.to_machine(place);
  }
  void half_circle(double from, double to) { turn(from, to, (from + to) / 2); }
  void circle(double from, double to) { turn(from, to, 0); }

  void turn(double from, double to, double middle) {
    if (!is_near(at(to))) return report_far();
    ArcSpec spec{at(from), at(to), at(middle), Plane::xy, pocket_.ccw, 0};
    Result<Arc> made = Arc::make(spec);
    if (!made)
      return task_.out.report(made.error().code, task_.word.pos, std::move(made.error().message));
    emit_move(task_, std::move(*made));
    task_.modal.position = spec.to;
    ++blocks_;
  }

  void report_far() {
    task_.out.report(Code::SC3008, span_of(task_.values, "XYZIK"),
                     leads_far(code_name(task_.code)));
  }

  Task& task_;
  const Pocket& pocket_;
  AxisVector center_;
  int blocks_ = 0;
};

/// Z of the first loop: in G91 each loop goes deeper by it.
double depth_of(const Task& task, const AxisVector& center) {
  const double z = task.values['Z'] * task.modal.mm_per_unit;
  return task.modal.incremental ? center[2] + z : z;
}

/// The centre, at the height of the tool.
AxisVector center_of(const Task& task) {
  AxisVector center = task.modal.coordinates.to_program(task.modal.position);
  for_named_axes(task, [&](int axis, double value) {
    if (axis != 2) center[axis] = task.modal.incremental ? center[axis] + value : value;
  });
  return center;
}

void cut_pocket(Task& task, const Pocket& pocket) {
  const AxisVector center = center_of(task);
  const AxisVector over = task.modal.coordinates.to_machine(center);
  if (!is_near(over))
    return task.out.report(Code::SC3008, span_of(task.values, "XY"), leads_far("the centre"));
  move_straight(task, over, false);
  PocketPath path(task, pocket, center);
  const double step = task.modal.incremental ? task.values['Z'] * task.modal.mm_per_unit : 0;
  double depth = depth_of(task, center);
  for (int i = 0; i < pocket.loops && task.out.errors() == 0; ++i, depth += step) {
    path.plunge(depth);
    path.cut();
  }
  task.flow.count_more_blocks(std::max(path.blocks() - 1, 0));
}

}  // namespace

/// The tool goes to the centre and down at the feed, and ends in the centre, at the depth.
void circular_pocket(Task& task) {
  compare_offsets(task);
  const auto pocket = pocket_of(task);
  if (has_feed(task) && has_plane_axes(task, plane_axes(Plane::xy)) && pocket)
    cut_pocket(task, *pocket);
}

}  // namespace softcnc::ipr
