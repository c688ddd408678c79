// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <pybind11/eigen.h>

#include <limits>

#include "ipr/expressions/dialect.hpp"
#include "runtime/session/feed_script.hpp"

namespace softcnc::python {
namespace {

/// A function of Python as a limit of the speed.
class PythonLimit final : public api::Constraint {
 public:
  PythonLimit(py::function function, Interruption& interruption)
      : function_(std::move(function)), interruption_(interruption) {}
  ~PythonLimit() override {
    const py::handle function = function_.release();
    with_gil([&] { function.dec_ref(); });
  }

  double largest_speed(const api::PathPoint& point) const noexcept override {
    double speed = std::numeric_limits<double>::infinity();
    const bool is_called = with_gil([&] {
      try {
        speed = call(point);
      } catch (...) {
        interruption_.end_with(std::current_exception());
      }
    });
    if (!is_called) interruption_.end_with(nullptr);
    return speed;
  }

 private:
  double call(const api::PathPoint& point) const {
    const py::object speed =
        function_(point.position, point.tangent, point.curvature, point.feed, point.rapid);
    if (!py::isinstance<py::float_>(speed) && !py::isinstance<py::int_>(speed))
      throw py::type_error("a limit must return a speed, mm/s");
    const auto value = speed.cast<double>();
    if (!(value > 0)) throw py::value_error("a limit must return a speed above 0, mm/s");
    return value;
  }

  py::function function_;
  Interruption& interruption_;
};

api::Dialect dialect_of(const std::string& asked) {
  if (asked == ipr::kGuessed) return api::Dialect::automatic;
  std::string known = ipr::kGuessed;
  for (const ipr::Dialect dialect : ipr::kAllDialects) {
    if (ipr::name(dialect) == asked) return static_cast<api::Dialect>(dialect);
    known += ", " + std::string(ipr::name(dialect));
  }
  throw py::value_error("no dialect '" + asked + "'; there are " + known);
}

}  // namespace

api::RunOptions run_options(const Options& options, Interruption& interruption) {
  const py::gil_scoped_acquire held;
  api::RunOptions run;
  run.dialect = dialect_of(options.dialect);
  run.feed_override = options.feed_override;
  run.block_skip = options.block_skip;
  run.optional_stop = options.optional_stop;
  run.subprogram_folders = options.subprograms;
  run.definitions = options.define;
  run.state = options.state;
  if (!(options.feed_override > 0 && options.feed_override <= runtime::kLargestOverride))
    throw py::value_error("feed_override must be above 0 and at most 2");
  if (!options.limit.is_none())
    run.constraints.push_back(
        std::make_shared<PythonLimit>(options.limit.cast<py::function>(), interruption));
  return run;
}

void add_options(py::module_& module) {
  py::class_<Options>(module, "Options")
      .def(py::init<>())
      .def_readwrite("dialect", &Options::dialect)
      .def_readwrite("feed_override", &Options::feed_override)
      .def_readwrite("block_skip", &Options::block_skip)
      .def_readwrite("optional_stop", &Options::optional_stop)
      .def_readwrite("subprograms", &Options::subprograms)
      .def_readwrite("define", &Options::define)
      .def_readwrite("state", &Options::state)
      .def_readwrite("limit", &Options::limit);
}

}  // namespace softcnc::python
