// SPDX-License-Identifier: MIT
// Passes that lie side by side: the phase between their cutting edges, and how the surface slopes
// from one to the next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "motion/geometry/path.hpp"
#include "motion/model/setpoint.hpp"
#include "motion/roughness/roughness_request.hpp"

namespace softcnc::runtime {

/// The cosine of 45 degrees: a sharper turn begins another pass.
inline constexpr double kPassTurn = 0.7071;

/// A neighbouring pass as seen from a place on a later one.
struct NeighbourPass {
  double distance = 0;    // mm, from above, square to the feed
  bool opposite = false;  // it runs the other way
  double lag = 0;         // of a tooth, 0 to 1/2, if it does not and the feed was even there
  double slope = 0;       // rad, of the surface square to the feed
};

/// Follows the rows of cutting moves. A pass begins after a rapid, and where the path turns by more
/// than 45 degrees; it is remembered until some others have come that are no shorter than links.
/// One that runs beside itself, as a smooth spiral does, is not noticed.
class PassNeighbours {
 public:
  explicit PassNeighbours(double period) : period_(period) {}

  /// The block of the row begins `begin` mm along the path. Returns what lies beside it, once a
  /// pick-feed.
  std::optional<NeighbourPass> add(const Setpoint& row, const Path& path, double begin,
                                   const Surface& surface);

 private:
  struct Place {
    AxisVector at;  // mm
    double teeth;   // that have passed since the pass began
    double v;       // mm/s
  };
  struct Pass {
    std::vector<Place> places;
    double length = 0;       // mm, from above
    std::size_t cursor = 0;  // near the place that was asked for last
    int misses = 0;
  };
  struct Offset {
    double aside, rise;  // mm, from above and upwards
    double heading;      // cosine
    double lag;          // of a tooth
  };

  void keep(const Place& place);
  bool begins_pass(const Setpoint& row, const Path& path, double begin, double time);
  bool turns(const AxisVector& advance) const noexcept;
  void begin_pass(double time, double pick_feed);
  std::optional<NeighbourPass> neighbour(const Place& place, double pick_feed);
  static double teeth_at(const Place& a, const Place& b, double part) noexcept;
  std::optional<Offset> offset(Pass& pass, const Place& place, double pick_feed) const;
  static std::size_t nearest(Pass& pass, const AxisVector& at, double near);

  double period_;             // s
  std::deque<Pass> earlier_;  // the last one first
  Pass present_;
  double reported_ = 0;     // mm: its length at the last report
  double begun_ = 0;        // s: when the present pass began
  double block_begun_ = 0;  // likewise its block
  int block_ = 0;
  std::int64_t last_period_ = -2;
  AxisVector last_ = AxisVector::Zero(), kept_ = AxisVector::Zero();  // mm: last row, last place
  AxisVector advance_ = AxisVector::Zero(),
             advance_before_ = AxisVector::Zero();  // from place to place
  AxisVector heading_ = AxisVector::Zero();         // from row to row
};

}  // namespace softcnc::runtime
