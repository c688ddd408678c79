// SPDX-License-Identifier: MIT
// The window of a machine without jerk limits: the exact optimum by two passes.
//
// Speeds are final as soon as they no longer depend on what follows. The backward pass is run once
// from rest at the end of the window and once from the highest speed there; left of the node where
// the two meet they agree bit by bit. Where they do not meet, what the forward pass makes of both
// is final as far as it agrees: a machine that accelerates has met neither. So the plan is that of
// the whole program, however the program arrives and wherever the window ends.
#pragma once

#include <vector>

#include "ipo/acceleration_limited/schedule.hpp"
#include "ipo/path/window.hpp"

namespace softcnc::ipo {

class ExactWindow final : public Window {
 public:
  using Window::Window;

  std::size_t settle(bool ended) override;
  std::optional<std::size_t> rest_early(double resolution) override;
  bool run_front(Profile& profile, std::optional<Limit> as) override;
  void set_front(double v, double) noexcept override { q_ = v * v; }
  bool front_rests() const noexcept override { return q_ == 0; }

 private:
  void slow_down(bool ended);
  std::size_t begin_alike(const std::vector<double>& other) noexcept;
  double reachable_from_rest(std::size_t end);
  void backward_pass(std::size_t last);
  bool brakes_to_corner(std::size_t node) const noexcept;
  ControllableInterval controllable(std::size_t interval) const noexcept;
  const IntervalConstraints& interval_constraints(std::size_t interval) const noexcept;

  double q_ = 0;  // at the front node
  std::vector<SpeedPiece> pieces_, other_pieces_;
  std::vector<IntervalConstraints>
      interval_constraints_;            // of what the last backward pass has covered,
  std::size_t passed_constraints_ = 0;  // and how many of them lie left of the front
};

}  // namespace softcnc::ipo
