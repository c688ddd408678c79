// SPDX-License-Identifier: MIT
#include "runtime/conversion/program_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/core/units.hpp"
#include "motion/geometry/deviation.hpp"
#include "motion/geometry/section.hpp"
#include "runtime/conversion/biarcs.hpp"

namespace softcnc::runtime {
namespace {

/// A number without needless zeros; coordinates to a nanometre.
std::string number(double value) {
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

/// The difference of places matters for knots, not their decimals.
std::string knot(double value) { return fmt::format("{:.12g}", value); }

/// Curves are exact; lines and arcs are one curve again where they are twice as near to it as G64
/// says.
std::string follow_code(CurveForm form, double tolerance) {
  const bool exact = form == CurveForm::g06_2 || form == CurveForm::g05_2;
  return exact ? "G61" : "G64 P" + number(2 * tolerance);
}

bool is_in_xy_plane(const Nurbs& curve) {
  const auto& points = curve.spec().control;
  return std::all_of(points.begin(), points.end(),
                     [&](const AxisVector& point) { return point[2] == points.front()[2]; });
}

}  // namespace

ProgramWriter::ProgramWriter(const Machine& machine, CurveForm form, double tolerance,
                             const Write& write)
    : machine_(machine),
      form_(form),
      tolerance_(tolerance),
      follow_(follow_code(form, tolerance)),
      write_(write) {
  add("G21 G90 G17 G94 G40 G49 G80 " + follow_);
}

void ProgramWriter::add(std::string_view line) {
  write_(line);
  write_("\n");
}

void ProgramWriter::write(const Block& block) {
  std::visit([this](const auto& what) { write(what); }, block.what);
}

std::string ProgramWriter::words(const AxisVector& to) const {
  std::string words;
  for (int i = 0; i < kAxes; ++i)
    if (machine_.axes[static_cast<std::size_t>(i)].present)
      words += fmt::format(" {}{}", kAxisLetters[static_cast<std::size_t>(i)], number(to[i]));
  return words;
}

void ProgramWriter::set_modes(const Move& move) {
  if (move.path_mode != std::exchange(mode_, move.path_mode))
    add(mode_ == PathMode::stop ? "G61.1" : follow_);
  feed_word_.clear();
  if (move.rapid) return;
  set_surface(move.surface);
  const double feed = mm_min_from_mm_s(move.feed);
  if (feed != std::exchange(feed_, feed)) feed_word_ = fmt::format(" F{:.9g}", feed);
}

/// The speed of the spindle is that of the program.
void ProgramWriter::set_surface(std::optional<Surface> surface) {
  if (surface) surface->spindle = 0;
  if (surface == std::exchange(surface_, surface)) return;
  if (!surface) return add("G06.5");
  std::string line = fmt::format("G06.4 D{:.12g} J{:.12g} H{:.12g} L{}", surface->tool_radius,
                                 surface->pick_feed, um_from_mm(surface->rmax), surface->teeth);
  if (surface->transverse_curvature != 0)
    line += fmt::format(" R{:.12g}", 1 / surface->transverse_curvature);
  if (surface->slope_across != 0)
    line += fmt::format(" Q{:.12g}", deg_from_rad(surface->slope_across));
  add(line);
}

void ProgramWriter::write(const Move& move) {
  set_modes(move);
  if (std::holds_alternative<Line>(move.path)) return write_line(end(move.path), move.rapid);
  if (const auto* arc = std::get_if<Arc>(&move.path))
    return form_ == CurveForm::g1 ? write_chords(move.path) : write_arc(*arc);
  const Nurbs& curve = std::get<Nurbs>(move.path);
  switch (form_) {
    case CurveForm::g06_2:
      return write_nurbs(curve);
    case CurveForm::g05_2:
      return write_splines(curve);
    case CurveForm::g1g2g3:
      if (is_in_xy_plane(curve)) return write_biarcs(move.path);
      [[fallthrough]];
    case CurveForm::g1:
      return write_chords(move.path);
  }
}

void ProgramWriter::write_line(const AxisVector& to, bool rapid) {
  add((rapid ? "G00" : "G01") + words(to) + std::exchange(feed_word_, {}));
  ++counts_.lines;
}

void ProgramWriter::write_arc(const Arc& arc) {
  constexpr std::array<const char*, 3> kPlanes{"G17", "G18", "G19"};
  constexpr std::string_view kOffsets = "IJK";
  const PlaneAxes axes = plane_axes(arc.plane());
  std::string line = fmt::format("{} {}", kPlanes[static_cast<std::size_t>(arc.plane())],
                                 arc.ccw() ? "G03" : "G02") +
                     words(arc.to());
  for (const int i : {axes.first, axes.second})
    line += fmt::format(" {}{}", kOffsets[static_cast<std::size_t>(i)],
                        number(arc.center()[i] - arc.from()[i]));
  if (arc.turns() > 0) line += fmt::format(" P{}", arc.turns() + 1);
  add(line + std::exchange(feed_word_, {}));
  ++counts_.lines;
}

void ProgramWriter::write_nurbs(const Nurbs& curve) {
  const NurbsSpec& spec = curve.spec();
  for (std::size_t i = 0; i < spec.knots.size(); ++i) {
    std::string line = i == 0 ? fmt::format("G06.2 P{} ", spec.degree + 1) : std::string();
    line += "K" + knot(spec.knots[i]);
    if (i < spec.control.size())
      line += words(spec.control[i]) + fmt::format(" R{:.12g}", spec.weights[i]);
    add(line + std::exchange(feed_word_, {}));
  }
  counts_.lines += spec.knots.size();
  counts_.control_points += spec.control.size();
}

/// Its knots are equal steps, so that every span is a spline of its own.
void ProgramWriter::write_splines(const Nurbs& curve) {
  const Path path = curve;
  double from = 0;
  std::vector<double> ends(curve.breaks().begin(), curve.breaks().end());
  ends.push_back(curve.length());
  for (const double to : ends) {
    const Path part = section(path, from, to);
    from = to;
    const auto* span = std::get_if<Nurbs>(&part);
    if (!span || span->spec().degree < 2) {
      write_chords(part);
      continue;
    }
    const NurbsSpec& spec = span->spec();
    add(fmt::format("G05.2 P{:.12g} L{}", spec.weights.front(), spec.degree + 1) +
        std::exchange(feed_word_, {}));
    for (std::size_t i = 1; i < spec.control.size(); ++i)
      add(words(spec.control[i]).substr(1) + fmt::format(" P{:.12g}", spec.weights[i]));
    add("G05.3");
    counts_.lines += spec.control.size() + 1;
    counts_.control_points += spec.control.size();
  }
}

/// The longest chords whose distance from the path, at places between, is within the tolerance.
void ProgramWriter::write_chords(const Path& path) {
  constexpr int kPlaces = 8;
  constexpr double kShortest = 1e-5;  // mm
  const double end = length(path);
  const auto fits = [&](double s, double t) {
    const AxisVector from = position(path, s), to = position(path, t);
    for (int i = 1; i < kPlaces; ++i)
      if (distance_to_segment(position(path, s + (t - s) * i / kPlaces), from, to) > tolerance_)
        return false;
    return true;
  };
  double step = end;
  for (double s = 0; s < end;) {
    step = std::min(2 * step, end - s);
    while (step > kShortest && !fits(s, s + step)) step *= 0.9;
    if (end - s - step < kShortest) step = end - s;
    s += step;
    write_line(position(path, s), false);
  }
}

void ProgramWriter::write_biarcs(const Path& path) {
  as_biarcs(path, tolerance_, [&](const Path& part) {
    if (const auto* arc = std::get_if<Arc>(&part))
      write_arc(*arc);
    else
      write_line(end(part), false);
  });
}

void ProgramWriter::write(const Dwell& dwell) { add("G04 P" + number(dwell.duration)); }

void ProgramWriter::write(const Action& action) {
  using Kind = Action::Kind;
  const int code = action.value != 0 && action.kind == Kind::coolant
                       ? static_cast<int>(action.value)
                       : action.code;
  switch (action.kind) {
    case Kind::tool:
      surface_.reset();
      return add(fmt::format("T{:g} M06", action.value));
    case Kind::spindle: {
      const bool turns = action.value != 0;
      if (!turns) return add("M05");
      return add(fmt::format("S{:.9g} M0{}", std::abs(action.value), action.value > 0 ? 3 : 4));
    }
    case Kind::output:
      if (action.port.kind == SignalKind::analog)
        return add(fmt::format("M68 E{} Q{:.9g}", action.port.number, action.value));
      return add(fmt::format("M{} P{}", action.value != 0 ? 64 : 65, action.port.number));
    case Kind::coolant:
    case Kind::stop:
    case Kind::end:
      return add(fmt::format("M{:02}", code));
    case Kind::probe:  // of a machine that reads one: programs are converted without it
      return;
  }
}

}  // namespace softcnc::runtime
