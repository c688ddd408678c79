// SPDX-License-Identifier: MIT
#include "pictures/isometric_axes.hpp"

#include <cmath>
#include <string>

#include "pictures/chart.hpp"
#include "pictures/ticks.hpp"

namespace softcnc::app {
namespace {

constexpr double kTicksApart = 46;    // px between ticks
constexpr double kIsometricTick = 5;  // px
constexpr double kCorner = 12;  // px beside the corner in front, where the end of X has its number

/// An edge of the box that has a scale: along `axis`, from a corner.
struct ScaledEdge {
  int axis;
  AxisVector from, to;
  Spot outwards;  // unit vector on the picture, in which ticks point
  Anchor anchor;
};

class BoxAxes {
 public:
  BoxAxes(Canvas& canvas, const Box& box, const Placing& placing)
      : canvas_(canvas), box_(box), placing_(placing) {}

  void draw() {
    for (const int axis : {0, 1, 2}) draw_grid(axis);
    const AxisVector &low = box_.low, &high = box_.high;
    const AxisVector front(high[0], low[1], low[2]);
    draw_edge({0, low, front, {-0.6, 0.8}, Anchor::right});
    draw_edge({1, front, {high[0], high[1], low[2]}, {0.6, 0.8}, Anchor::left});
    draw_edge({2, low, {low[0], low[1], high[2]}, {-1, 0}, Anchor::right});
  }

 private:
  Spot spot(const AxisVector& point) const { return placing_(seen(PathView::isometric, point)); }

  Ticks ticks(int axis) const {
    const double length = (box_.high - box_.low)[axis];
    const double shortened = std::sqrt(2.0 / 3);  // as all axes in an isometric view
    return round_ticks(box_.low[axis], box_.high[axis],
                       most_ticks(length * shortened * placing_.scale(), kTicksApart));
  }

  /// The lines at which an axis has its ticks: across the floor and up a wall, or around both
  /// walls.
  void draw_grid(int axis) {
    const Pen pen{.colour = kGrid, .width = 1};
    const Ticks marks = ticks(axis);
    for (int i = -1; i <= marks.count; ++i) {
      AxisVector a = box_.low, b = box_.low, c = box_.high;
      if (axis == 2) {
        a = {box_.low[0], box_.low[1], 0};
        b = {box_.low[0], box_.high[1], 0};
      } else if (axis == 0) {
        b[1] = box_.high[1];
        c[1] = box_.high[1];
      } else {
        a[0] = box_.high[0];
        c[0] = box_.low[0];
      }
      const double value = i < 0              ? box_.low[axis]
                           : i == marks.count ? box_.high[axis]
                                              : marks.at(i);
      a[axis] = b[axis] = c[axis] = value;
      const Spot spots[] = {spot(a), spot(b), spot(c)};
      canvas_.line(spots, pen);
    }
  }

  void draw_edge(const ScaledEdge& edge) {
    const Pen pen{.colour = kFrame, .width = 1};
    canvas_.line(spot(edge.from), spot(edge.to), pen);
    const Ticks marks = ticks(edge.axis);
    TextLook look = kTickLook;
    look.anchor = edge.anchor;
    for (int i = 0; i < marks.count; ++i) {
      AxisVector point = edge.from;
      point[edge.axis] = marks.at(i);
      const Spot at = spot(point);
      canvas_.line(
          at, {at.x + kIsometricTick * edge.outwards.x, at.y + kIsometricTick * edge.outwards.y},
          pen);
      if (edge.axis == 1 && std::abs(at.x - spot(edge.from).x) < kCorner) continue;
      canvas_.text({at.x + (kIsometricTick + 3) * edge.outwards.x,
                    at.y + (kIsometricTick + 4) * edge.outwards.y + 4},
                   marks.label(i), look);
    }
    draw_name(edge);
  }

  void draw_name(const ScaledEdge& edge) {
    const Spot from = spot(edge.from), to = spot(edge.to);
    TextLook look = kLabelLook;
    look.anchor = edge.anchor;
    const double away = 34;
    canvas_.text({(from.x + to.x) / 2 + away * edge.outwards.x,
                  (from.y + to.y) / 2 + away * edge.outwards.y + 4},
                 std::string(1, kAxisLetters[static_cast<std::size_t>(edge.axis)]) + ", mm", look);
  }

  Canvas& canvas_;
  const Box& box_;
  const Placing& placing_;
};

}  // namespace

void draw_isometric_axes(Canvas& canvas, const Box& box, const Placing& placing) {
  BoxAxes(canvas, box, placing).draw();
}

}  // namespace softcnc::app
