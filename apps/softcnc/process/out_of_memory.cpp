// SPDX-License-Identifier: MIT
#include "process/out_of_memory.hpp"

#include <unistd.h>

#include <atomic>
#include <new>
#include <system_error>

#include "process/signal_cleanup.hpp"
#include "process/standard_error.hpp"

namespace softcnc::app {
namespace {

constexpr int kStatus = 5;

/// Where nothing may be thrown, the exception itself is no longer to be had.
std::atomic<bool> ran_out{false};
std::terminate_handler otherwise = nullptr;

[[noreturn]] void no_memory() {
  ran_out = true;
  throw std::bad_alloc();
}

[[noreturn]] void terminate() noexcept {
  if (!ran_out) otherwise();
  clean_up_now();
  write_to_stderr("softcnc: error: out of memory [SC6004]\n");
  ::_exit(kStatus);
}

}  // namespace

std::string lacking_resource(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error)) return "out of memory";
  const auto* system = dynamic_cast<const std::system_error*>(&error);
  if (!system) return {};
  const bool lacks = system->code() == std::errc::resource_unavailable_try_again ||
                     system->code() == std::errc::not_enough_memory;
  return lacks ? "no more memory or threads: " + system->code().message() : std::string();
}

void handle_out_of_memory() noexcept {
  std::set_new_handler(no_memory);
  otherwise = std::set_terminate(terminate);
}

}  // namespace softcnc::app
