// SPDX-License-Identifier: MIT
// A convex quadratic programme over the control points of a spline of degree 5: squares of linear
// forms are minimised, and others stay between bounds. Every form reaches over the six control
// points of one knot span, so that all matrices are banded.
//
// Method: primal-dual interior point with a predictor and a corrector (S. Mehrotra, 1992), one
// banded factorisation a step. First-order iterations are of no use here: weights range over ten
// decades.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "ipo/solver/control_band.hpp"

namespace softcnc::ipo {

template <int dimensions>
class TubeProgram {
 public:
  using Band = ControlBand<dimensions>;
  using Vector = typename Band::Vector;
  using Matrix = typename Band::Matrix;
  /// Directions of one place that may be bounded: three across the path, one along it.
  static constexpr int kDirections = dimensions == 2 ? 2 : 4;

  /// The spline has a place sum(basis[i] * control[first + i]); its component along each direction
  /// stays between `low` and `high`.
  struct Bounds {
    int first = 0;
    QuinticBasis basis{};
    int count = 0;
    std::array<Vector, kDirections> direction;
    std::array<double, kDirections> low{}, high{};
  };

  struct Outcome {
    bool solved = false;
    int steps = 0;
  };

  explicit TubeProgram(std::size_t points);

  /// Adds 1/2 d' metric d with d = sum(basis[i] * control[first + i]) - goal; `metric` is symmetric
  /// and has no negative eigenvalue.
  void add_cost(int first, const QuinticBasis& basis, const Matrix& metric, const Vector& goal);
  void add_bounds(const Bounds& bounds) { bounds_.push_back(bounds); }

  /// Moves the control points from `begin` on, before `end`, to where the cost is smallest; the
  /// others stay. Returns solved = false where no such points were found within the bounds.
  Outcome solve(std::vector<Vector>& control, std::size_t begin, std::size_t end);

 private:
  using Values = std::vector<double>;

  /// The distances from the bounds and their multipliers, by row; also steps of these.
  struct Slacks {
    Values low, high, dual_low, dual_high;
    void resize(std::size_t rows);
    double gap() const;
  };
  struct Step {
    std::vector<Vector> control;
    Slacks slacks;
  };
  /// By how much products of slacks and multipliers are to be off those of the barrier.
  struct Products {
    Values low, high;
  };

  void scale();
  Values values(const std::vector<Vector>& control) const;
  std::vector<Vector> transposed(const Values& multipliers) const;
  std::vector<Vector> gradient(const std::vector<Vector>& control) const;
  double cost(const std::vector<Vector>& control) const;
  Slacks first_slacks(const std::vector<Vector>& control) const;
  void find_missing(const std::vector<Vector>& control);
  bool is_solved(const std::vector<Vector>& control) const;
  bool factor();
  Step find_step(const std::vector<Vector>& slope, double barrier, const Products& off) const;
  Products products(const Slacks& step) const;
  double gap_after(const Slacks& step) const;
  double longest_primal(const Slacks& step) const;
  double longest_dual(const Slacks& step) const;
  void advance(const Step& step, std::vector<Vector>& control);

  std::size_t points_;
  std::vector<Bounds> bounds_;
  std::size_t rows_ = 0;  // of all bounds
  Band hessian_;
  std::vector<Vector> linear_;
  double constant_ = 0;
  Band factor_;
  Values low_, high_;                  // the bounds, by row
  Values missing_low_, missing_high_;  // by how much the slacks are too small
  Slacks now_;
  std::size_t begin_ = 0, end_ = 0;  // free control points
};

extern template class TubeProgram<2>;
extern template class TubeProgram<3>;

}  // namespace softcnc::ipo
