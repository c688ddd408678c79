// SPDX-License-Identifier: MIT
// The stretch of path between what is already timed and what is not yet read.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "ipo/path/chain.hpp"
#include "ipo/path/profile.hpp"

namespace softcnc::ipo {

/// What the plans have taken so far, where speeds are found by iteration.
struct PlanEffort {
  std::size_t nodes = 0, iterations = 0;
  std::size_t work = 0;  // nodes times iterations, and as much as that for setting up and checking
  std::size_t fallbacks = 0;  // plans that were not found: the machine stops early or goes slowly

  PlanEffort& operator+=(const PlanEffort& more) noexcept {
    nodes += more.nodes;
    iterations += more.iterations;
    work += more.work;
    fallbacks += more.fallbacks;
    return *this;
  }
};

/// The path in it, and its front; how fast the machine may go is for the two kinds of window to
/// say.
class Window {
 public:
  /// `share`: of the axis accelerations and jerks, 1 for all.
  Window(const Constraints& constraints, double share) : constraints_(constraints), share_(share) {}
  virtual ~Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Appends a move; `rest`: why the machine rests where it begins, if it does. The move must stay
  /// where it is until the front has passed it.
  void append(const Move& move, RestBefore rest);

  /// The same where the feed is to be another one: `slower` caps the move from the place on
  /// at which, as slow_down() finds, the machine can have slowed down to it.
  void append(const Move& move, RestBefore rest, const Cap& slower);
  /// The next settle() looks for the shortest way in which the machine can slow down; it could stop
  /// within `stop` mm.
  void slow_down(double stop) noexcept {
    slows_ = true;
    stop_ = stop;
  }
  /// Nothing was found: there is a faster way alone, and settle() does not know it.
  bool lost() const noexcept { return lost_; }
  /// mm from the front at slow_down() to where the slower caps count.
  double slowing_way() const noexcept { return slowing_way_; }

  /// Moves the front past `moves` moves and `s` mm into the next one.
  void skip(std::size_t moves, double s);

  /// Intervals from the front on.
  std::size_t size() const noexcept { return chain_.intervals.size() - front_; }
  /// Those of the move appended last.
  std::span<const Interval> last_move() const noexcept;

  /// Finds the speeds and returns the number of intervals, from the front, whose speeds are final.
  /// `ended`: nothing follows the window, so all are, and the machine rests at its end.
  virtual std::size_t settle(bool ended) = 0;
  /// Whether settle() goes on a stretch at a time: where it has found speeds it may find more at
  /// once.
  virtual bool settles_by_stretches() const noexcept { return false; }

  /// After settle(true): plans rest at the nearest node, to within `resolution` mm, at which the
  /// machine can stand, and returns the number of intervals up to it; nothing if it cannot stand
  /// anywhere in the window.
  virtual std::optional<std::size_t> rest_early(double resolution) = 0;

  /// After settle(): runs the first interval, appends its pieces and drops it; true if its move
  /// ends there. `as`: what the pieces are to say holds them back.
  virtual bool run_front(Profile& profile, std::optional<Limit> as = {}) = 0;

  /// Speed and acceleration at the front, mm/s and mm/s^2.
  virtual void set_front(double v, double a) noexcept = 0;
  virtual bool front_rests() const noexcept = 0;

  virtual PlanEffort effort() const noexcept { return {}; }

  /// How the direction of the path jumps at the front.
  struct Turn {
    bool turns;
    bool shares_its_step;   // with a curve or another turn
    Directions directions;  // within a period of it
  };
  Turn front_turn() const noexcept;

 protected:
  /// The last node that nothing behind the window can still ask anything of.
  std::size_t last_final_cap() const noexcept;
  /// Moves the front over its interval; true if its move ends there.
  bool drop_front();

  /// A node at s, mm from the first node ever, or at the first rest before it; splits an interval
  /// unless one of its ends lies nearer than this part of it. The front is none.
  std::size_t node_at(double s, double part);
  /// The first node at which the machine rests anyway, mm of the chain.
  double first_rest() const noexcept;
  /// The chain as it was appended, slower from `way` mm ahead of the front on.
  void slow_from(const Chain& appended, double way);

  /// Notes, before the front is run, whether it is at a rest that a corner forces. A motion that
  /// has begun there may stand for the first intervals after it, too.
  void begin_ramp(bool rests) noexcept {
    const Node& front = chain_.nodes[front_];
    if (rests && front.own.q == 0) ramps_.begin(front.forces_rest());
  }

  /// Caps of what has been appended since.
  void derive();
  /// All caps, once intervals have been split or lowered.
  void derive_anew();

  const Constraints& constraints_;
  double share_;
  Chain chain_;
  RestRamps ramps_;
  std::size_t derived_to_ = 0;  // nodes left of it have their caps
  bool slows_ = false, lost_ = false;
  double stop_ = 0, slowing_way_ = 0;
  std::size_t front_ = 0;  // what lies left of it is kept for what it asks of its neighbours

 private:
  void forget();

  static constexpr std::size_t kFewPassed = 1024;  // intervals
  std::size_t forget_at_ = kFewPassed;             // intervals behind the front
};

/// How much of the way ahead a plan with limits of jerk covers, if it has not ended before.
struct Horizon {
  double stops = 10;  // stopping distances, and
  double time = 0.5;  // s that it lasts while its cap stays, if it can be found

  /// All of the program in one plan, where kMostNodes are enough.
  static constexpr Horizon whole() noexcept { return {kUnlimited, kUnlimited}; }
};

/// The kind of window that the limits of the machine ask for.
std::unique_ptr<Window> make_window(const Constraints& constraints, double share = 1,
                                    const Horizon& horizon = {});

}  // namespace softcnc::ipo
