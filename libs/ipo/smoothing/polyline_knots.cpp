// SPDX-License-Identifier: MIT
// Where lines are dense: a mesh of knots along them, as wide as its curve proves to be near enough.
#include <algorithm>
#include <cmath>

#include "ipo/smoothing/polyline.hpp"

namespace softcnc::ipo {
namespace {

constexpr double kNear = 0.5;     // of a width: knots that need not be proved to be near enough
constexpr double kGrowth = 1.25;  // from one spacing to the next
constexpr double kAhead = 4;      // spacings: whose turns may use knots that are near
constexpr double kWideAhead = 2;  // and others
constexpr double kWayOn = 6;      // near spacings: more than what shapes the spans between

/// Knots this part of a spacing apart, or nearer, are avoided, by taking off this part at a time.
constexpr double kCrowded = 1.0 / 32;
constexpr double kLess = 1.0 / 256;
constexpr int kTries = 48;
constexpr int kLastTries = 4;  // for the spacing of the last knots of a mesh

/// What a spacing may turn by, rad, use of the tolerance, and reach over.
constexpr double kTurn = 0.3;
constexpr double kShare = 0.3;
constexpr std::size_t kLines = 16;

constexpr std::size_t kAwaited = 8;  // lines

constexpr std::size_t kFixed = 5;    // hats at a time
constexpr std::size_t kFree = 12;    // hats at most that are not fixed
constexpr std::size_t kShaping = 3;  // hats in front that shape the next span
constexpr double kNarrower = 0.6;
constexpr int kRetreats = 5;

}  // namespace

/// The turns that have their width together are those of a circle, w^2 / 12 P. On it the spline is
/// h^4 / 14.4 rho^3 off.
double LineRun::spacing_of_knots(std::size_t i) const {
  const LineVertex &v = vertices_[i], &before = vertices_[i - std::min(i, kLines)];
  const double radius = v.width * v.width / (12 * v.tolerance);
  const double off = std::sqrt(std::sqrt(14.4 * kShare * v.tolerance * radius) * radius);
  const double lines = static_cast<double>(v.programmed - before.programmed);
  const double most = (v.t - before.t) * std::min(1.0, static_cast<double>(kLines) / lines);
  return std::max(std::min({kTurn * radius, off, most}), kNear * v.width);
}

/// How far behind `from` the next knot may lie, at most `most`, unproved: no further than half the
/// width of any turn that could use it, those behind `back` among them.
std::optional<LineRun::Spacing> LineRun::spacing(std::size_t near, double from, double back,
                                                 double most) const {
  std::size_t j = near;
  while (j > 0 && vertices_[j - 1].t > back) --j;
  for (; j < vertices_.size() && vertices_[j].t < from + kAhead * most; ++j) {
    if (j >= densities_) return std::nullopt;
    if (!vertices_[j].dense) return Spacing{most, j - 1};
    most = std::min(most, kNear * vertices_[j].width);
  }
  if (j == vertices_.size()) return std::nullopt;
  return Spacing{most, {}};
}

/// A spacing as it is given or a little less, for the next knot behind `from`.
double LineRun::uncrowded_spacing(double from, double spacing) const {
  for (int k = 0; k < kTries; ++k) {
    const double less = spacing * (1 - k * kLess);
    if (!is_close_to_knots(from + less, kCrowded * spacing)) return less;
  }
  return spacing;
}

/// A mesh begins in a vertex, its first hat symmetric. False while it is not known how wide.
bool LineRun::begin_mesh() {
  const LineVertex& first = vertices_[bent_];
  const auto ahead = spacing(bent_, first.t, first.t, kNear * first.width);
  if (!ahead) return false;
  if (ahead->stop) {
    bend_at_vertex();
    return true;
  }
  const double h = uncrowded(first.t, ahead->most);
  const double free_from = std::max(first.t, pieces_.bends().back().furthest);
  mesh_ = Mesh{ChordMesh(vertices_, bent_, h), vertices_[bent_ - 1].direction, free_from, {}};
  return true;
}

/// False while lines that are still to come could change what is laid next. They are not looked for
/// with every line.
bool LineRun::extend_mesh() {
  Mesh& mesh = *mesh_;
  if (densities_ < mesh.awaited && !ended_) return false;
  if (!fix()) return await_lines();
  if (is_complete(mesh)) {
    end_mesh();
    return true;
  }
  if (!lay(mesh, true)) return await_lines();
  if (!look(mesh)) retreat();
  return true;
}

bool LineRun::await_lines() {
  mesh_->awaited = densities_ + kAwaited;
  return false;
}

bool LineRun::is_complete(const Mesh& mesh) const {
  return mesh.stop && mesh.chords.mean() >= vertices_[*mesh.stop].t - kSamePlace;
}

/// Lays the next knot. False while it is not known where.
bool LineRun::lay(Mesh& mesh, bool wide) const {
  ChordMesh& chords = mesh.chords;
  const double h = chords.spacing(), from = chords.last();
  if (mesh.stop) {
    chords.lay(vertices_, last_spacing(mesh, h), true);
    return true;
  }
  const auto far = wide ? wide_spacing(mesh) : 0;
  if (!far) return false;
  if (*far > 0) {
    chords.lay(vertices_, *far, false);
    return true;
  }
  const auto ahead = spacing(chords.edge(chords.hats() - 1) + 1, from, chords.mean(), kGrowth * h);
  if (!ahead) return false;
  mesh.stop = ahead->stop;
  const double spacing = mesh.stop ? last_spacing(mesh, std::min(h, ahead->most))
                                   : uncrowded_spacing(from, ahead->most);
  chords.lay(vertices_, spacing, true);
  return true;
}

/// How far the next knot may lie, if its curve proves to be near enough; 0 where no others than
/// hats between near knots may be: where hats of other turns reach, or before these on the way on
/// with near knots.
std::optional<double> LineRun::wide_spacing(const Mesh& mesh) const {
  const ChordMesh& chords = mesh.chords;
  const double from = chords.last(), back = chords.mean();
  const std::size_t hats = chords.hats();
  if (hats < kShaping || chords.knot(hats - 1) < mesh.free_from) return 0;
  if (mesh.retreats >= kRetreats) return 0;
  double most = kGrowth * chords.spacing(), widest = 0;
  if (from < mesh.most_until) most = std::min(most, mesh.most);
  if (!(most > 0)) return 0;
  std::size_t j = chords.edge(hats - 1) + 1;
  while (j > 0 && vertices_[j - 1].t > back) --j;
  for (;; ++j) {
    if (j >= densities_) return std::nullopt;
    const LineVertex& v = vertices_[j];
    if (!v.dense) return 0;
    widest = std::max(widest, kNear * v.width);
    if (v.t < from + kWideAhead * most)
      most = std::min(most, v.spacing);
    else if (v.t - v.reach >= from + most + kWayOn * widest)
      return most;
  }
}

/// With which the last hat of a mesh is that of its last vertex, and its end not close to a vertex
/// behind.
double LineRun::last_spacing(const Mesh& mesh, double most) const {
  const LineVertex& stop = vertices_[*mesh.stop];
  const double rest = stop.t - mesh.chords.last();
  if (!(rest > kSamePlace)) return mesh.chords.spacing();
  const double fewest = std::ceil(rest / most - kSamePlace);
  for (int more = 0; more < kLastTries; ++more) {
    const double spacing = rest / (fewest + more);
    const double end = stop.t + spacing, least = kCrowded * spacing;
    bool close = false;
    for (std::size_t j = *mesh.stop + 1; j < vertices_.size() && vertices_[j].t < end + least; ++j)
      close = close || is_close(vertices_[j].t, end, least);
    if (!close) return spacing;
  }
  return rest / fewest;
}

/// Whether all spans that are complete are near enough.
bool LineRun::look(Mesh& mesh) const {
  for (; mesh.looked < mesh.chords.complete_spans(); ++mesh.looked)
    if (!mesh.chords.is_near_span(mesh.looked) &&
        mesh.chords.measure(vertices_, mesh.looked).share > 1)
      return false;
  return true;
}

bool LineRun::shapes_near(const Mesh& mesh, std::size_t hats) {
  for (std::size_t i = hats - std::min(hats, kShaping); i < hats; ++i)
    if (!mesh.chords.is_near(i)) return false;
  return true;
}

/// Fixes hats whose spans are near enough, if there is a way on. False while that is not known.
bool LineRun::fix() {
  Mesh& mesh = *mesh_;
  const std::size_t hats = std::min(mesh.looked + 1, mesh.chords.hats());
  if (hats <= mesh.fixed) return true;
  if (!shapes_near(mesh, hats)) {
    if (hats < mesh.fixed + kFixed || hats == mesh.tried) return true;
    const auto on = goes_on_near(hats);
    if (!on) return false;
    mesh.tried = hats;
    if (!*on) {
      if (mesh.chords.hats() > mesh.fixed + kFree) mesh.retreats = kRetreats, retreat();
      return true;
    }
  }
  mesh.fixed = hats;
  mesh.retreats = 0;
  bend_along(hats);
  return true;
}

/// Whether from so many hats on knots near each other would do. Nothing while that is not known.
std::optional<bool> LineRun::goes_on_near(std::size_t hats) const {
  Mesh on = *mesh_;
  on.chords.cut_back(hats);
  on.stop.reset();
  on.looked = hats - 1;
  while (!shapes_near(on, on.looked + 1)) {
    if (is_complete(on)) return false;
    if (!lay(on, false)) return std::nullopt;
    if (!look(on)) return false;
  }
  return true;
}

/// Leaves what is fixed, and lays the knots behind narrower.
void LineRun::retreat() {
  Mesh& mesh = *mesh_;
  const double end = mesh.chords.knot(mesh.looked + 1);
  const double width = end - mesh.chords.knot(mesh.looked);
  mesh.chords.cut_back(mesh.fixed);
  mesh.looked = mesh.fixed - 1;
  mesh.stop.reset();
  mesh.tried = 0;
  ++mesh.retreats;
  mesh.most = kNarrower * width;
  mesh.most_until = std::max(end, mesh.chords.last()) + width;
}

/// Hands on the bends of hats of which the line behind is known too.
void LineRun::bend_along(std::size_t hats) {
  Mesh& mesh = *mesh_;
  const ChordMesh& chords = mesh.chords;
  for (; mesh.bent + 1 < hats; ++mesh.bent) {
    const std::size_t edge = chords.edge(mesh.bent), next = chords.edge(mesh.bent + 1);
    double deviation = 0;
    for (std::size_t i = edge; i <= next; ++i)
      deviation = std::max(deviation, vertices_[i].deviation);
    const AxisVector direction = chords.direction(mesh.bent);
    Turn turn = chords.turn(mesh.bent);
    turn.kink = direction - mesh.direction;
    mesh.direction = direction;
    pieces_.add({turn, chords.point(mesh.bent), direction, deviation, vertices_[edge].manner,
                 chords.deviation(mesh.bent)});
    bent_ = std::max(bent_, edge + 1);
  }
  const std::size_t forgotten = mesh.chords.forget_hats(mesh.bent);
  for (std::size_t* count : {&mesh.looked, &mesh.fixed, &mesh.bent}) *count -= forgotten;
  mesh.tried = 0;
}

/// The last bend, whose line is that of its vertex.
void LineRun::end_mesh() {
  Mesh& mesh = *mesh_;
  const ChordMesh& chords = mesh.chords;
  const std::size_t last = chords.hats() - 1, edge = chords.edge(last);
  if (mesh.fixed <= last) {
    mesh.retreats = kRetreats;
    retreat();
    return;
  }
  const LineVertex& v = vertices_[edge];
  Turn turn = chords.turn(last);
  turn.kink = v.direction - mesh.direction;
  pieces_.add({turn, chords.point(last), v.direction, v.deviation, v.manner, {}});
  bent_ = std::max(bent_, edge + 1);
  mesh_.reset();
}

}  // namespace softcnc::ipo
