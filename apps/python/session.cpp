// SPDX-License-Identifier: MIT
#include "runtime/session/session.hpp"

#include <pybind11/eigen.h>

#include "arrays.hpp"
#include "bindings.hpp"
#include "hal/backends/backend.hpp"
#include "options.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::python {
namespace {

using Names = std::vector<std::string>;

constexpr std::array<const char*, 6> kStatusNames{"running", "waiting", "paused",
                                                  "done",    "alarm",   "error"};

/// A session of the runtime with what it refers to.
class Session {
 public:
  Session(const api::Machine& machine, const Options& options, bool simulated,
          const api::AxisVector& start)
      : machine_(machine.data().machine) {
    machine_.control.backend = simulated ? BackendKind::sim : BackendKind::none;
    auto backend = hal::open_backend(machine_);
    if (!backend) raise(api::error_of(backend.error()));
    backend_ = std::move(*backend);
    options_ = run_options(options, interruption_);
    options_.start = start;
    setup_.emplace(options_, nullptr);
    session_.emplace(machine_, setup_->channel(), *backend_);
  }

  /// Returns up to `most` rows.
  py::dict step(std::int64_t most, const std::optional<Names>& asked) {
    ArrayTrace trace(machine_, runtime::row_columns(*backend_), asked);
    if (trace.unknown())
      throw py::value_error("no column '" + *trace.unknown() + "' in this session");
    interruptible([&](Interruption& interruption) {
      const std::stop_token stop = interruption.stop(), raised = interruption_.stop();
      for (std::int64_t i = 0; i < most && !stop.stop_requested() && !raised.stop_requested();
           ++i) {
        const auto row = session_->step();
        if (!row) break;
        trace.row(row->setpoint, row->values);
      }
    });
    interruption_.raise();
    if (!trace.ok()) throw std::bad_alloc();
    return trace.take();
  }

  bool feed(const std::string& text) {
    return session_->takes_more() && session_->feed(text).has_value();
  }
  runtime::Session& operator*() noexcept { return *session_; }
  const char* status() const noexcept {
    return kStatusNames[static_cast<std::size_t>(session_->status())];
  }
  std::vector<api::Diagnostic> diagnostics() const {
    return api::diagnostics_of(session_->diagnostics());
  }
  api::State state() {
    return api::State(std::make_unique<api::State::Data>(api::State::Data{session_->state()}));
  }

 private:
  Machine machine_;
  Interruption interruption_;  // by functions of Python, which the session keeps
  api::RunOptions options_;
  std::optional<api::RunSetup> setup_;
  std::unique_ptr<hal::Backend> backend_;
  std::optional<runtime::Session> session_;
};

}  // namespace

void add_session(py::module_& module) {
  py::class_<Session>(module, "Session")
      .def(py::init<const api::Machine&, const Options&, bool, const api::AxisVector&>())
      .def("feed", &Session::feed)
      .def("step", &Session::step)
      .def("end", [](Session& session) { (*session).end(); })
      .def("rest", [](Session& session) { (*session).rest(); })
      .def("go_on", [](Session& session) { (*session).go_on(); })
      .def("hold", [](Session& session) { (*session).hold(); })
      .def("resume", [](Session& session) { (*session).resume(); })
      .def("abort", [](Session& session) { (*session).abort(); })
      .def("set_feed_override",
           [](Session& session, double value) { (*session).set_feed_override(value); })
      .def("position", [](Session& session) { return api::AxisVector((*session).position()); })
      .def("status", &Session::status)
      .def("diagnostics", &Session::diagnostics)
      .def("state", &Session::state);
}

}  // namespace softcnc::python
