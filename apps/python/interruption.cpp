// SPDX-License-Identifier: MIT
#include "interruption.hpp"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>

namespace softcnc::python {

void Interruption::end_with(std::exception_ptr reason) noexcept {
  const std::lock_guard lock(mutex_);
  if (!reason_) reason_ = std::move(reason);
  source_.request_stop();
}

void Interruption::raise() {
  const std::lock_guard lock(mutex_);
  if (reason_) std::rethrow_exception(reason_);
}

void interruptible(const std::function<void(Interruption&)>& work) {
  constexpr std::chrono::milliseconds kBetweenLooks(50);
  Interruption interruption;
  {
    const pybind11::gil_scoped_release released;
    std::future<void> done = std::async(std::launch::async, [&] { work(interruption); });
    while (done.wait_for(kBetweenLooks) != std::future_status::ready) {
      const pybind11::gil_scoped_acquire held;
      if (PyErr_CheckSignals() != 0)
        interruption.end_with(std::make_exception_ptr(pybind11::error_already_set()));
    }
    done.get();
  }
  interruption.raise();
}

}  // namespace softcnc::python
