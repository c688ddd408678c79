// SPDX-License-Identifier: MIT
// Long work without the GIL, which Ctrl-C and exceptions of Python functions end.
#pragma once

#include <exception>
#include <functional>
#include <mutex>
#include <stop_token>

namespace softcnc::python {

class Interruption {
 public:
  std::stop_token stop() const noexcept { return source_.get_token(); }
  /// Ends the work, which then raises this. Only the first one counts.
  void end_with(std::exception_ptr reason) noexcept;
  /// Raises what has ended the work, once.
  void raise();

 private:
  std::stop_source source_;
  std::mutex mutex_;
  std::exception_ptr reason_;
};

/// Calls a function of Python from any thread: work() holds the GIL. Does nothing and returns false
/// once the interpreter is about to end, when that thread could get no GIL any more.
bool with_gil(const std::function<void()>& work);

/// Lets the interpreter wait for with_gil() before it ends.
void wait_at_exit();

/// Does work(interruption) on a thread of its own, without the GIL, while this thread looks for
/// signals: KeyboardInterrupt is raised once the work has ended for it. Requires the GIL.
void interruptible(const std::function<void(Interruption&)>& work);

}  // namespace softcnc::python
