// SPDX-License-Identifier: MIT
// Curves: evaluated at many parameters or arc lengths at once.
#include "motion/geometry/nurbs.hpp"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>

#include <cmath>

#include "api/convert.hpp"
#include "bindings.hpp"

namespace softcnc::python {
namespace {

using Points = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Numbers = Eigen::VectorXd;

Nurbs curve(const Points& control, int degree, std::vector<double> knots,
            std::vector<double> weights) {
  if (control.cols() != 2 && control.cols() != kAxes)
    throw py::value_error("control points must have two or three numbers each");
  NurbsSpec spec;
  spec.degree = degree;
  spec.knots = std::move(knots);
  for (Eigen::Index i = 0; i < control.rows(); ++i) {
    AxisVector point = AxisVector::Zero();
    point.head(control.cols()) = control.row(i).transpose();
    spec.control.push_back(point);
  }
  spec.weights =
      weights.empty() ? std::vector<double>(spec.control.size(), 1.0) : std::move(weights);
  auto made = Nurbs::make(std::move(spec));
  if (!made) raise(api::error_of(made.error()));
  return std::move(*made);
}

/// Returns f(u) for each u within the curve, one row each.
template <typename Function>
Points each_row(const Numbers& u, Function&& f) {
  Points rows(u.size(), kAxes);
  for (Eigen::Index i = 0; i < u.size(); ++i) rows.row(i) = f(u[i]).transpose();
  return rows;
}

template <typename Function>
Numbers each_number(const Numbers& u, Function&& f) {
  Numbers numbers(u.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) numbers[i] = f(u[i]);
  return numbers;
}

double within(const Nurbs& nurbs, double u) {
  if (!std::isfinite(u)) throw py::value_error("parameters must be finite");
  return std::clamp(u, nurbs.u_first(), nurbs.u_last());
}

Points derivative(const Nurbs& nurbs, const Numbers& u, std::size_t order) {
  if (order < 1 || order > 3) throw py::value_error("derivatives have an order of 1 to 3");
  return each_row(u, [&](double at) { return nurbs.derivatives(within(nurbs, at))[order]; });
}

}  // namespace

void add_nurbs(py::module_& module) {
  py::class_<Nurbs>(module, "Nurbs")
      .def(py::init(&curve))
      .def("length", &Nurbs::length)
      .def("domain", [](const Nurbs& n) { return std::pair(n.u_first(), n.u_last()); })
      .def("degree", [](const Nurbs& n) { return n.spec().degree; })
      .def("knots", [](const Nurbs& n) { return n.spec().knots; })
      .def("weights", [](const Nurbs& n) { return n.spec().weights; })
      .def("control",
           [](const Nurbs& n) {
             const auto& control = n.spec().control;
             Points points(static_cast<Eigen::Index>(control.size()), kAxes);
             for (std::size_t i = 0; i < control.size(); ++i)
               points.row(static_cast<Eigen::Index>(i)) = control[i].transpose();
             return points;
           })
      .def("point",
           [](const Nurbs& n, const Numbers& u) {
             return each_row(u, [&](double at) { return n.point(within(n, at)); });
           })
      .def("derivative", derivative)
      .def("arc_length",
           [](const Nurbs& n, const Numbers& u) {
             return each_number(u, [&](double at) { return n.arc_length(within(n, at)); });
           })
      .def("parameter", [](const Nurbs& n, const Numbers& s) {
        return each_number(s,
                           [&](double at) { return n.parameter(std::clamp(at, 0.0, n.length())); });
      });
}

}  // namespace softcnc::python
