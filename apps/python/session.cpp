// SPDX-License-Identifier: MIT
#include "runtime/session/session.hpp"

#include <pybind11/eigen.h>

#include <mutex>
#include <stdexcept>

#include "arrays.hpp"
#include "bindings.hpp"
#include "hal/backends/backend.hpp"
#include "options.hpp"
#include "runtime/sinks/contour_rows.hpp"

namespace softcnc::python {
namespace {

constexpr std::array<const char*, 6> kStatusNames{"running", "waiting", "paused",
                                                  "done",    "alarm",   "error"};

/// A session of the runtime with what it refers to.
class Session {
 public:
  Session(const api::Machine& machine, const Options& options, bool simulated,
          const std::optional<api::AxisVector>& start)
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
    if (interruption_.stop().stop_requested())
      throw std::runtime_error("this session has ended: its limit has raised an exception");
    ArrayTrace trace(machine_, runtime::row_columns(*backend_), asked);
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
  std::mutex& mutex() noexcept { return mutex_; }
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
  std::mutex mutex_;  // held while a thread uses the session
  Machine machine_;
  Interruption interruption_;  // by functions of Python, which the session keeps
  api::RunOptions options_;
  std::optional<api::RunSetup> setup_;
  std::unique_ptr<hal::Backend> backend_;
  std::optional<runtime::Session> session_;
};

/// Returns a function that uses a session, which only one thread can do at a time.
template <typename... Arguments, typename Use>
auto alone(Use use) {
  return [use](Session& session, Arguments... arguments) {
    const std::unique_lock lock(session.mutex(), std::try_to_lock);
    if (!lock) throw std::runtime_error("another thread uses this session");
    return use(session, arguments...);
  };
}

}  // namespace

void add_session(py::module_& module) {
  using Columns = std::optional<Names>;
  py::class_<Session>(module, "Session")
      .def(py::init<const api::Machine&, const Options&, bool,
                    const std::optional<api::AxisVector>&>())
      .def("feed",
           alone<std::string>([](Session& s, const std::string& text) { return s.feed(text); }))
      .def("step",
           alone<std::int64_t, Columns>([](Session& s, std::int64_t most, const Columns& asked) {
             return s.step(most, asked);
           }))
      .def("end", alone([](Session& s) { (*s).end(); }))
      .def("rest", alone([](Session& s) { (*s).rest(); }))
      .def("go_on", alone([](Session& s) { (*s).go_on(); }))
      .def("hold", alone([](Session& s) { (*s).hold(); }))
      .def("resume", alone([](Session& s) { (*s).resume(); }))
      .def("abort", alone([](Session& s) { (*s).abort(); }))
      .def("set_feed_override",
           alone<double>([](Session& s, double value) { (*s).set_feed_override(value); }))
      .def("set_rapid_override",
           alone<double>([](Session& s, double value) { (*s).set_rapid_override(value); }))
      .def("position", alone([](Session& s) { return api::AxisVector((*s).position()); }))
      .def("status", alone([](Session& s) { return s.status(); }))
      .def("diagnostics", alone([](Session& s) { return s.diagnostics(); }))
      .def("state", alone([](Session& s) { return s.state(); }));
}

}  // namespace softcnc::python
