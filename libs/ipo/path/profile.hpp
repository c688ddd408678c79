// SPDX-License-Identifier: MIT
// Distance as a function of time within a block.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "ipo/path/ramp.hpp"
#include "ipo/tuning.hpp"
#include "motion/model/setpoint.hpp"

namespace softcnc::ipo {

/// Where a move is at one instant, and what limits it there.
struct State {
  double s = 0;  // mm from the start of the move
  double v = 0;  // mm/s
  double a = 0;  // mm/s^2
  Limit limit = Limit::stop;
};

/// s(t) of one block in polynomial pieces, from t = 0 (s and t within the block).
class Profile {
 public:
  /// Adds a piece of constant acceleration from (s0, v0) to (s1, v1). Pieces follow one another.
  void add_piece(double s0, double s1, double v0, double v1, Limit limit);
  /// Adds a piece of degree five that meets position, speed and acceleration at both ends.
  void add_ramp(const Ramp& ramp);
  /// Adds a rest at the present position (s = 0 if there is no piece yet).
  void add_rest(double duration);
  /// Adds a rest of no duration at s.
  void rest_at(double s);
  /// Adds a rest without an end at the present position, and names what holds the machine there.
  void add_hold(Limit limit);
  /// Ends the profile where the rest without an end begins, if there is one.
  void end_hold() noexcept;

  /// Returns what is left of it at t; t = 0 is there.
  Profile from(double t) const;

  std::size_t pieces() const noexcept { return pieces_.size(); }
  /// Returns its first `count` pieces, or those after them.
  Profile first(std::size_t count) const;
  Profile after(std::size_t count) const;
  /// Appends those pieces as if they had been added one by one.
  void append(const Profile& more);

  double duration() const noexcept { return duration_; }
  /// Returns the speed at its end, mm/s.
  double end_speed() const noexcept;
  /// Returns the position at its end, mm from the start of the move.
  double end_place() const noexcept { return pieces_.empty() ? 0 : pieces_.back().s1; }
  bool empty() const noexcept { return pieces_.empty(); }

  /// Realtime. `hint` carries the piece from call to call while t grows; it must start at 0.
  State at(double t, std::size_t& hint) const noexcept;

  /// Returns the first instant at which s is reached.
  double time_at(double s) const noexcept;

  /// Calls visit(motion, its start, its duration) for the piece at t and those after it, as long as
  /// that returns true.
  template <typename Visit>
  void for_each_from(double t, Visit&& visit) const {
    const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), t,
                                        [](double a, const Piece& piece) { return a < piece.t0; });
    auto piece = after == pieces_.begin() ? after : after - 1;
    while (piece != pieces_.end() && visit(piece->curve, piece->t0, piece->duration)) ++piece;
  }

  /// A piece as others see it: from one instant and position to the next.
  struct Span {
    double t0 = 0, t1 = 0;  // s
    double s0 = 0, s1 = 0;  // mm
    double v0 = 0, v1 = 0;  // mm/s
    Limit limit = Limit::stop;

    /// Whether the machine moves in it.
    bool moves() const noexcept { return s1 > s0; }
    /// Whether the machine moves in it and comes to rest.
    bool ends_at_rest() const noexcept { return moves() && v1 <= tuning::path::kStandstill; }
  };
  /// Passes each of its pieces that has a duration, as far as it lies before `until`, s, to
  /// sink(span).
  template <typename Sink>
  void for_each_span(double until, Sink&& sink) const {
    for (const Piece& piece : pieces_) {
      if (piece.t0 >= until) return;
      if (piece.duration > 0) sink(span(piece, until));
    }
  }

  /// Calls sink(limit, duration) for each of its pieces.
  template <typename Sink>
  void for_each_piece(Sink&& sink) const {
    for (const Piece& piece : pieces_) sink(piece.limit, piece.duration);
  }

 private:
  struct Piece {
    double t0, duration;
    Quintic curve;
    double s1;  // where it ends
    Limit limit;
  };
  void add(Piece piece);
  static Span span(const Piece& piece, double until) noexcept;
  static double time_to(const Piece& piece, double s) noexcept;

  std::vector<Piece> pieces_;
  double duration_ = 0;
};

}  // namespace softcnc::ipo
