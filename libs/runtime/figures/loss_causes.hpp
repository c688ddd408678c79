// SPDX-License-Identifier: MIT
// Why a program loses time against its feed: reversals, corners, rests and curves, each counted.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include "ipo/queue/block_queue.hpp"

namespace softcnc::runtime {

enum class LossKind : std::uint8_t {
  reversal,  // an axis goes back where it came from
  corner,    // the path turns; the axis is the one whose velocity has to change most
  rest,   // the machine starts or ends at rest: at a rapid, a dwell, an action, the program's end
  curve,  // within a move, or where moves join without a corner
};
inline constexpr std::array<std::string_view, 4> kLossKinds{"reversal", "corner", "rest", "curve"};
constexpr std::string_view name(LossKind kind) noexcept {
  return kLossKinds[static_cast<std::size_t>(kind)];
}

/// A cause of lost time, all its places together.
struct LossCause {
  LossKind kind = LossKind::curve;
  int axis = -1;              // of a reversal or a corner
  Limit limit = Limit::feed;  // of a curve: what limits the feed there
  std::int64_t count = 0;     // how often it was met
  double lost = 0;            // s beyond those that the length takes at the programmed feed
  double from = 0, to = 0;    // mm, machine coordinates along the axis: its places lie between them
  bool only_ends = true;      // every place is at one of the two
};

/// Adds up by cause what cutting moves lose. The ramps at both sides of a joint are the joint's.
/// Memory is bounded.
class LossCauses {
 public:
  /// The first `until` s of a block; `feed_override` is what counts in it. Blocks come in the order
  /// in which they are run.
  void add(const ipo::TimedBlock& timed, double until, double feed_override);

  /// Returns the causes, the worst first.
  std::vector<LossCause> causes() const;

 private:
  /// What is lost in the three parts of a block: from its start, as long as the speed grows; up to
  /// its end, from where it only falls; and between them.
  struct Parts {
    double head = 0, tail = 0;
    std::array<double, kLimits> middle{};
    Limit first = Limit::feed, last = Limit::feed;  // that hold at its start and its end
  };
  struct Open {
    bool cuts = false;  // the block before was a cutting move
    double tail = 0;    // s, that it has lost before its end
    AxisVector end = AxisVector::Zero(), direction = AxisVector::Zero();
    Limit limit = Limit::feed;
    bool at_rest = false;  // it ends at rest
  };
  struct Sum {
    LossCause cause;
    std::set<double> places;  // mm, the first few that differ
  };

  static Parts parts_of(const ipo::TimedBlock& timed, double until, double feed);
  void close();
  void pass_joint(const AxisVector& direction, const Parts& parts);
  void count(LossKind kind, int axis, Limit limit, double lost, double place = 0);

  Open open_;
  std::vector<Sum> sums_;
};

}  // namespace softcnc::runtime
