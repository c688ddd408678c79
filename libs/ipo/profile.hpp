// SPDX-License-Identifier: MIT
// When a move is where: its speeds as a function of time.
#pragma once

#include <cstddef>
#include <vector>

#include "motion/setpoint.hpp"

namespace softcnc::ipo {

/// Where a move is at one instant, and what holds it back there.
struct State {
  double s = 0;  // mm from the start of the move
  double v = 0;  // mm/s
  double a = 0;  // mm/s^2
  Limit limit = Limit::stop;
};

/// s(t) of one block in pieces of constant acceleration, from t = 0 (s and t within the block).
class Profile {
 public:
  /// A piece from (s0, v0) to (s1, v1), v^2 linear in s. Pieces follow one another.
  void add_piece(double s0, double s1, double v0, double v1, Limit limit);
  /// Rest at the present place (s = 0 if there is no piece yet).
  void add_rest(double duration);
  /// Rest at s, for no time.
  void rest_at(double s);

  /// What is left of it at t; t = 0 is there.
  Profile from(double t) const;

  double duration() const noexcept { return duration_; }
  /// mm/s, where it ends.
  double end_speed() const noexcept;
  bool empty() const noexcept { return pieces_.empty(); }

  /// Realtime. `hint` carries the piece from call to call while t grows; start it at 0.
  State at(double t, std::size_t& hint) const noexcept;

  /// The first instant at which s is reached.
  double time_at(double s) const noexcept;

  /// Adds the duration of its pieces to what each limit holds.
  template <typename Sink>
  void for_each_piece(Sink&& sink) const {
    for (const Piece& piece : pieces_) sink(piece.limit, piece.duration);
  }

 private:
  struct Piece {
    double t0, duration;
    double s0, s1, v0, a;
    Limit limit;
  };
  std::vector<Piece> pieces_;
  double duration_ = 0;
};

}  // namespace softcnc::ipo
