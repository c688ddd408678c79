// SPDX-License-Identifier: MIT
// The part of the path between what is already timed and what is not yet read.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "ipo/path/chain.hpp"
#include "ipo/path/profile.hpp"
#include "ipo/tuning.hpp"

namespace softcnc::ipo {

/// What the plans have cost so far, where speeds are found by iteration.
struct PlanEffort {
  std::size_t nodes = 0, iterations = 0;
  std::size_t work = 0;       // nodes times iterations, and the same measure of set-up and checks
  std::size_t fallbacks = 0;  // plans that were not found: the machine stops early or moves slowly

  PlanEffort& operator+=(const PlanEffort& more) noexcept {
    nodes += more.nodes;
    iterations += more.iterations;
    work += more.work;
    fallbacks += more.fallbacks;
    return *this;
  }
};

/// The path within the window and its front. The two kinds of window decide how fast the machine
/// may move.
class Window {
 public:
  /// `share` is the part of the axis accelerations and jerks that may be used; 1 for all.
  Window(const ConstraintList& constraints, double share)
      : constraints_(constraints), share_(share) {}
  virtual ~Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Appends a move. `rest` says why the machine rests where it begins, if it does. The move must
  /// stay where it is until the front has passed it.
  void append(const Move& move, RestBefore rest);

  /// Appends a move where the feed is to change: `slower` limits the move from the place on at
  /// which the machine can have slowed down to it, as slow_down() finds.
  void append(const Move& move, RestBefore rest, const VelocityLimit& slower);
  /// Makes the next settle() look for the shortest distance in which the machine can slow down; it
  /// could stop within `stop` mm.
  void slow_down(double stop) noexcept {
    slows_ = true;
    stop_ = stop;
  }
  /// True if nothing was found: only a faster way exists, which settle() does not know.
  bool lost() const noexcept { return lost_; }
  /// Returns the distance, mm, from the front at slow_down() to where the slower limits take
  /// effect.
  double slowing_distance() const noexcept { return slowing_distance_; }

  /// Moves the front past `moves` moves and `s` mm into the next one.
  void skip(std::size_t moves, double s);

  /// Returns the number of intervals from the front on.
  std::size_t size() const noexcept { return chain_.intervals.size() - front_; }
  /// Returns the intervals of the move appended last.
  std::span<const Interval> last_move() const noexcept;

  /// Finds the speeds and returns the number of intervals, from the front, whose speeds are final.
  /// `ended`: nothing follows the window, so all of them are, and the machine rests at its end.
  virtual std::size_t settle(bool ended) = 0;
  /// Whether settle() proceeds part by part: where it has found speeds it may find more at once.
  virtual bool settles_by_stretches() const noexcept { return false; }

  /// After settle(true): plans a rest at the nearest node, to within `resolution` mm, at which the
  /// machine can stop, and returns the number of intervals up to it; nothing if it cannot stop
  /// anywhere in the window.
  virtual std::optional<std::size_t> rest_early(double resolution) = 0;

  /// After settle(): runs the first interval, appends its pieces and drops it. Returns true if its
  /// move ends there. `as` is the limit that the pieces name, if given.
  virtual bool run_front(Profile& profile, std::optional<Limit> as = {}) = 0;

  /// Sets speed and acceleration at the front, mm/s and mm/s^2.
  virtual void set_front(double v, double a) noexcept = 0;
  virtual bool front_rests() const noexcept = 0;

  virtual PlanEffort effort() const noexcept { return {}; }

  /// How the direction of the path jumps at the front.
  struct Turn {
    bool turns;
    bool shares_its_step;   // with a curve or another corner
    Directions directions;  // within a period of it
  };
  Turn front_turn() const noexcept;

  /// Returns the longest time, s, from a rest at a turn to the nearest sample with which the
  /// polyline through the samples leaves the corner by no more than the chord tolerance.
  double farthest_sample(const Turn& turn) const noexcept;

  /// Returns how long, s, the machine must wait at a rest at the front until the drives leave no
  /// more than the contour tolerance of what follows: a period at least, so that there is a sample
  /// in the rest; 0 if that goes straight on.
  double settling_time() const noexcept;

 protected:
  /// Returns the last node whose velocity limit cannot change any more, whatever follows the
  /// window.
  std::size_t last_final_limit() const noexcept;
  /// Moves the front over its interval; returns true if its move ends there.
  bool drop_front();

  /// Returns a node at s, mm from the first node ever, or at the first rest before it. Splits an
  /// interval unless one of its ends lies nearer than this part of it. The front itself is never
  /// returned.
  std::size_t node_at(double s, double part);
  /// Returns the first node at which the machine rests in any case, mm of the chain.
  double first_rest() const noexcept;
  /// Restores the chain as it was appended, slower from `distance` mm ahead of the front on.
  void slow_from(const Chain& appended, double distance);

  /// Notes, before the front is run, whether it is at a rest that a corner forces. A motion that
  /// has begun there may rest for the first intervals after it, too.
  void begin_ramp(bool rests) noexcept {
    const Node& front = chain_.nodes[front_];
    if (rests && front.own.q == 0) corner_naming_.begin(front.forces_rest());
  }

  /// Derives the velocity limits of what has been appended since.
  void derive();
  /// Derives all velocity limits, once intervals have been split or lowered.
  void derive_all();

  const ConstraintList& constraints_;
  double share_;
  Chain chain_;
  CornerNaming corner_naming_;
  std::size_t derived_to_ = 0;  // nodes left of it have their velocity limits
  bool slows_ = false, lost_ = false;
  double stop_ = 0, slowing_distance_ = 0;
  std::size_t front_ = 0;  // what lies left of it is kept for what it requires of its neighbours

 private:
  void forget();

  std::size_t forget_at_ = tuning::chain::kFewPassed;  // intervals left of the front
};

}  // namespace softcnc::ipo
