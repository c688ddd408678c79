// SPDX-License-Identifier: MIT
// Whether a corner is passed sooner on a curve that rounds it, or with a rest in it.
//
// Both ways are planned, as the planner plans all motions, over as much of the paths on either side
// as the machine needs to reach their feed, from rest to rest. So every limit counts as it does in
// the motion itself, a path and its reverse are treated alike, and a feed that the machine does not
// reach beside the corner does not matter. A curve on which nothing but the feed limits the speed
// needs no plan: it is shorter than the corner, and nothing brakes on it.
#pragma once

#include <memory>
#include <vector>

#include "ipo/limits/planner_limits.hpp"
#include "ipo/path/piece.hpp"
#include "motion/model/machine.hpp"

namespace softcnc::ipo {

/// What the planner can tell of motions before they are queued.
class TrialPlan {
 public:
  TrialPlan() = default;
  TrialPlan(const TrialPlan&) = delete;
  TrialPlan& operator=(const TrialPlan&) = delete;
  virtual ~TrialPlan() = default;

  /// Returns how long, s, a motion along these moves takes, which are connected, from rest to rest.
  virtual double time(const std::vector<Move>& moves) const = 0;
  /// Returns whether every limit allows a move at its programmed feed.
  virtual bool keeps_feed(const Move& move) const = 0;
};

/// One side of a corner: the path that leads to it or away from it, from `begin` to `end` mm.
struct CornerSide {
  const Path& path;
  double begin, end;
  MoveAttributes attributes;
};

/// A corner, and a curve that replaces it and `cut_before` and `cut_after` mm of the paths beside
/// it. The feed changes in the middle of the curve.
struct RoundedCorner {
  CornerSide before, after;
  const Path& curve;
  double cut_before, cut_after;
};

class CornerChoice {
 public:
  CornerChoice(const Machine& machine, std::unique_ptr<const TrialPlan> trial);

  /// Returns false where a rest in the corner is sooner.
  bool is_sooner(const RoundedCorner& corner) const;

 private:
  double needed(const CornerSide& side, double s) const;

  PlannerLimits limits_;
  AxisVector velocity_;  // mm/s; of absent axes: unlimited
  double feed_;          // mm/s: the largest of the machine
  std::unique_ptr<const TrialPlan> trial_;
};

}  // namespace softcnc::ipo
