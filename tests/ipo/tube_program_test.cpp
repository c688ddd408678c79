// SPDX-License-Identifier: MIT
#include "ipo/solver/tube_program.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "support/property.hpp"

using namespace softcnc::ipo;
using softcnc::test::integer;
using softcnc::test::real;

namespace {

using Program = TubeProgram<2>;
using ControlPoints = std::vector<Program::Vector>;

struct Cost {
  int first;
  QuinticBasis basis;
  Program::Matrix metric;
  Program::Vector goal;
};

struct Problem {
  std::size_t points = 0;
  std::vector<Cost> costs;
  std::vector<Program::Bounds> bounds;

  Program program() const {
    Program program(points);
    for (const Cost& cost : costs) program.add_cost(cost.first, cost.basis, cost.metric, cost.goal);
    for (const Program::Bounds& at : bounds) program.add_bounds(at);
    return program;
  }

  double cost_of(const ControlPoints& control) const {
    double sum = 0;
    for (const Cost& cost : costs) {
      const Program::Vector off = place(control, cost.first, cost.basis) - cost.goal;
      sum += 0.5 * off.dot(cost.metric * off);
    }
    return sum;
  }

  /// By how much the worst bound is exceeded.
  double outside(const ControlPoints& control) const {
    double most = 0;
    for (const Program::Bounds& at : bounds)
      for (std::size_t k = 0; k < static_cast<std::size_t>(at.count); ++k) {
        const double value = at.direction[k].dot(place(control, at.first, at.basis));
        most = std::max({most, at.low[k] - value, value - at.high[k]});
      }
    return most;
  }

  static Program::Vector place(const ControlPoints& control, int first, const QuinticBasis& basis) {
    Program::Vector sum = Program::Vector::Zero();
    for (std::size_t i = 0; i < basis.size(); ++i)
      sum += basis[i] * control[static_cast<std::size_t>(first) + i];
    return sum;
  }
};

QuinticBasis random_basis() {
  QuinticBasis basis;
  double sum = 0;
  for (double& value : basis) sum += value = real(0.01, 1);
  for (double& value : basis) value /= sum;
  return basis;
}

Program::Vector random_vector(double size) { return {real(-size, size), real(-size, size)}; }

Cost random_cost(std::size_t points) {
  Program::Matrix root;
  root << random_vector(1), random_vector(1);
  QuinticBasis basis;
  for (double& value : basis) value = real(-1, 1);
  return {integer(0, static_cast<int>(points) - 6), basis, root * root.transpose(),
          random_vector(3)};
}

/// Bounds around the places of points that lie inside all of them.
Problem random_problem(double half_width) {
  Problem problem;
  problem.points = static_cast<std::size_t>(integer(8, 20));
  ControlPoints inside;
  for (std::size_t i = 0; i < problem.points; ++i) inside.push_back(random_vector(1));
  for (std::size_t i = 0; i < 6 * problem.points; ++i)
    problem.costs.push_back(random_cost(problem.points));
  for (std::size_t i = 0; i < 2 * problem.points; ++i) {
    Program::Bounds at;
    at.first = integer(0, static_cast<int>(problem.points) - 6);
    at.basis = random_basis();
    at.count = 2;
    const double angle = real(0, 6.3);
    at.direction = {Program::Vector(std::cos(angle), std::sin(angle)),
                    Program::Vector(-std::sin(angle), std::cos(angle))};
    for (std::size_t k = 0; k < 2; ++k) {
      const double middle = at.direction[k].dot(Problem::place(inside, at.first, at.basis));
      at.low[k] = middle - half_width * real(0.1, 1);
      at.high[k] = middle + half_width * real(0.1, 1);
    }
    problem.bounds.push_back(at);
  }
  return problem;
}

ControlPoints zeros(std::size_t points) { return ControlPoints(points, Program::Vector::Zero()); }

}  // namespace

TEST_CASE("without bounds that matter, a tube programme solves the normal equations",
          "[tube_program][property]") {
  softcnc::test::holds([] {
    const Problem problem = random_problem(1e6);
    const auto size = static_cast<Eigen::Index>(2 * problem.points);
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(size);
    for (const Cost& cost : problem.costs) {
      Eigen::MatrixXd form = Eigen::MatrixXd::Zero(2, size);
      for (int i = 0; i < 6; ++i)
        form.block<2, 2>(0, 2 * (cost.first + i)) =
            cost.basis[static_cast<std::size_t>(i)] * Program::Matrix::Identity();
      hessian += form.transpose() * cost.metric * form;
      pull += form.transpose() * cost.metric * cost.goal;
    }
    const Eigen::VectorXd exact = hessian.ldlt().solve(pull);
    ControlPoints least = zeros(problem.points);
    for (std::size_t i = 0; i < problem.points; ++i)
      least[i] = exact.segment<2>(static_cast<Eigen::Index>(2 * i));
    ControlPoints found = zeros(problem.points);
    const auto outcome = problem.program().solve(found, 0, problem.points);
    RC_ASSERT(outcome.solved);
    const double best = problem.cost_of(least);
    RC_ASSERT(problem.cost_of(found) <= best * 1.004 + 1e-9);
    RC_ASSERT(problem.cost_of(found) >= best * (1 - 1e-9));
  });
}

TEST_CASE("no points within the bounds cost less than those that a tube programme finds",
          "[tube_program][property]") {
  softcnc::test::holds(
      [] {
        const Problem problem = random_problem(0.5);
        ControlPoints found = zeros(problem.points);
        RC_ASSERT(problem.program().solve(found, 0, problem.points).solved);
        RC_ASSERT(problem.outside(found) < 1e-8);
        const double cost = problem.cost_of(found);
        for (int i = 0; i < 20; ++i) {  // others within the bounds: of least other costs
          Problem other = problem;
          for (Cost& term : other.costs) term = random_cost(problem.points);
          ControlPoints elsewhere = zeros(problem.points);
          RC_ASSERT(other.program().solve(elsewhere, 0, problem.points).solved);
          RC_ASSERT(problem.outside(elsewhere) < 1e-8);
          for (const double part : {0.01, 0.1, 1.0}) {
            ControlPoints between = found;
            for (std::size_t k = 0; k < between.size(); ++k)
              between[k] += part * (elsewhere[k] - found[k]);
            RC_ASSERT(cost <= problem.cost_of(between) * 1.004 + 1e-9);
          }
        }
      },
      30);
}

TEST_CASE("control points that are given stay", "[tube_program][property]") {
  softcnc::test::holds([] {
    const Problem problem = random_problem(1e6);
    ControlPoints control(problem.points, Program::Vector(1, 2));
    RC_ASSERT(problem.program().solve(control, 3, problem.points - 2).solved);
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}, problem.points - 1})
      RC_ASSERT(control[i] == Program::Vector(1, 2));
    RC_ASSERT(control[3] != Program::Vector(1, 2));
  });
}

TEST_CASE("bounds that exclude each other have no solution", "[tube_program][property]") {
  softcnc::test::holds([] {
    Problem problem = random_problem(0.5);
    Program::Bounds other = problem.bounds.front();
    for (std::size_t k = 0; k < 2; ++k) {
      other.low[k] = other.high[k] + 1;
      other.high[k] = other.low[k] + 1;
    }
    problem.bounds.push_back(other);
    ControlPoints control = zeros(problem.points);
    RC_ASSERT(!problem.program().solve(control, 0, problem.points).solved);
  });
}
