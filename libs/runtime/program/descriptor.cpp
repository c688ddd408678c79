// SPDX-License-Identifier: MIT
#include "runtime/program/descriptor.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "motion/core/unnamed_file.hpp"

namespace softcnc::runtime {
namespace {

tl::unexpected<Diagnostic> no_temporary_file() {
  return tl::make_unexpected(Diagnostic{
      .code = Code::SC6003,
      .message = "cannot be kept in a temporary file: " + std::generic_category().message(errno)});
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

void wait_for_input(int descriptor, const std::stop_token& stop) {
  constexpr int kBetweenLooks = 100;  // ms
  pollfd source{descriptor, POLLIN, 0};
  const int time = stop.stop_possible() ? kBetweenLooks : -1;
  while (!stop.stop_requested() && ::poll(&source, 1, time) == 0) {
  }
}

bool has_input(int descriptor, int timeout) noexcept {
  pollfd source{descriptor, POLLIN, 0};
  return ::poll(&source, 1, timeout) != 0;
}

Result<Descriptor> unlinked_file() {
  Descriptor file(open_unnamed_file());
  if (*file < 0) return no_temporary_file();
  return file;
}

Status write_all(const Descriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(*file, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return no_temporary_file();
  }
  return {};
}

}  // namespace softcnc::runtime
