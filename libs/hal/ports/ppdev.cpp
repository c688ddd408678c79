// SPDX-License-Identifier: MIT
#include "hal/ports/ppdev.hpp"

#include <fcntl.h>
#include <linux/ppdev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace softcnc::hal {
namespace {

constexpr const char* kOpen = "open";
constexpr const char* kClaim = "PPCLAIM";

}  // namespace

/// A port that another driver has registered for itself alone is ENXIO to PPCLAIM, but a port that
/// does not exist is ENXIO to open().
Diagnostic port_refusal(const std::string& device, const char* call, int error) {
  const bool claim = std::strcmp(call, kClaim) == 0;
  const bool busy = error == EBUSY || error == EAGAIN || (claim && error == ENXIO);
  const std::string reason = std::string(" (") + call + ": " + std::strerror(error) + ')';
  if (busy)
    return {.code = Code::SC6073,
            .message = "another driver or program uses this port" + reason,
            .file = device};
  const char* what = error == EACCES || error == EPERM ? "no permission to use this port"
                     : error == ENOTTY                 ? "this is not a parallel port"
                                                       : "there is no such port";
  return {.code = Code::SC6072, .message = what + reason, .file = device};
}

Ppdev::Ppdev(std::string device, int descriptor)
    : device_(std::move(device)), descriptor_(descriptor) {}

Result<std::unique_ptr<Ppdev>> Ppdev::open(const std::string& device) {
  const int descriptor = ::open(device.c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return tl::make_unexpected(port_refusal(device, kOpen, errno));
  std::unique_ptr<Ppdev> port(new Ppdev(device, descriptor));
  if (!port->call(PPEXCL, nullptr))
    return tl::make_unexpected(port_refusal(device, "PPEXCL", port->error_));
  if (!port->call(PPCLAIM, nullptr))
    return tl::make_unexpected(port_refusal(device, kClaim, port->error_));
  port->claimed_ = true;
  int output = 0;
  if (!port->call(PPDATADIR, &output))
    return tl::make_unexpected(port_refusal(device, "PPDATADIR", port->error_));
  return port;
}

Ppdev::~Ppdev() {
  if (claimed_) ::ioctl(descriptor_, PPRELEASE);
  ::close(descriptor_);
}

bool Ppdev::write_data(std::uint8_t bits) noexcept { return call(PPWDATA, &bits); }
bool Ppdev::write_control(std::uint8_t bits) noexcept { return call(PPWCONTROL, &bits); }

std::optional<std::uint8_t> Ppdev::read_status() noexcept {
  std::uint8_t bits = 0;
  return call(PPRSTATUS, &bits) ? std::optional(bits) : std::nullopt;
}

/// The first error is reported; a port that has failed may still take what puts it at rest.
bool Ppdev::call(unsigned long request, void* argument) noexcept {
  while (::ioctl(descriptor_, request, argument) < 0) {
    if (errno == EINTR) continue;
    if (error_ == 0) error_ = errno;
    return false;
  }
  return true;
}

Diagnostic Ppdev::failure() const {
  return {.code = Code::SC6074,
          .message = std::string("the port fails: ") + std::strerror(error_),
          .file = device_};
}

}  // namespace softcnc::hal
