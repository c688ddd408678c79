// SPDX-License-Identifier: MIT
#include "interruption.hpp"

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>
#include <thread>
#include <utility>

namespace softcnc::python {
namespace {

std::atomic<int> calls_of_python = 0;
std::atomic<bool> is_ending = false;

/// Keeps the interpreter from ending while a thread waits for its GIL or holds it, which would end
/// that thread wherever it is. It is not open where the interpreter is about to end.
class EntryOfPython {
 public:
  EntryOfPython() noexcept { ++calls_of_python; }
  EntryOfPython(const EntryOfPython&) = delete;
  EntryOfPython& operator=(const EntryOfPython&) = delete;
  ~EntryOfPython() { leave(); }
  bool is_open() noexcept {
    if (is_ending) leave();
    return entered_;
  }

 private:
  void leave() noexcept {
    if (std::exchange(entered_, false)) --calls_of_python;
  }
  bool entered_ = true;
};

[[noreturn]] void sleep_for_ever() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

}  // namespace

void Interruption::end_with(std::exception_ptr reason) noexcept {
  const std::lock_guard lock(mutex_);
  if (!reason_) reason_ = std::move(reason);
  source_.request_stop();
}

void Interruption::raise() {
  const std::lock_guard lock(mutex_);
  if (reason_) std::rethrow_exception(std::exchange(reason_, nullptr));
}

bool with_gil(const std::function<void()>& work) {
  EntryOfPython entry;
  if (!entry.is_open()) return false;
  const pybind11::gil_scoped_acquire held;
  work();
  return true;
}

void wait_at_exit() {
  const auto wait = [] {
    is_ending = true;
    const pybind11::gil_scoped_release released;
    while (calls_of_python > 0) std::this_thread::yield();
  };
  pybind11::module_::import("atexit").attr("register")(pybind11::cpp_function(wait));
}

void interruptible(const std::function<void(Interruption&)>& work) {
  constexpr std::chrono::milliseconds kBetweenLooks(50);
  Interruption interruption;
  std::optional<pybind11::gil_scoped_release> released(std::in_place);
  std::future<void> done = std::async(std::launch::async, [&] { work(interruption); });
  while (done.wait_for(kBetweenLooks) != std::future_status::ready) {
    with_gil([&] {
      if (PyErr_CheckSignals() != 0)
        interruption.end_with(std::make_exception_ptr(pybind11::error_already_set()));
    });
  }
  EntryOfPython entry;
  if (!entry.is_open()) sleep_for_ever();  // a daemon thread, whose process ends
  released.reset();
  done.get();
  interruption.raise();
}

}  // namespace softcnc::python
