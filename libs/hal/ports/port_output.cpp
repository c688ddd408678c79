// SPDX-License-Identifier: MIT
#include "hal/ports/port_output.hpp"

#include <utility>

namespace softcnc::hal {

PortOutput::PortOutput(std::unique_ptr<PortRegisters> registers, const Machine& machine)
    : registers_(std::move(registers)), pins_(machine), device_(machine.parallel_port.device) {}

Alarm PortOutput::write(const PortWord& word) noexcept {
  word_ = word;
  return write_again();
}

Alarm PortOutput::write_again() noexcept {
  const PortWord word = pins_.at(word_, tick_++);
  bool written = true;
  if (!last_ || word.control != last_->control) written = registers_->write_control(word.control);
  if (!last_ || word.data != last_->data) written = registers_->write_data(word.data) && written;
  last_ = word;
  return written ? Alarm::none : Alarm::port;
}

Alarm PortOutput::look() noexcept {
  if (!pins_.looks()) return Alarm::none;
  const auto status = registers_->read_status();
  if (!status) return Alarm::port;
  inputs_ = pins_.inputs(*status);
  return pins_.alarm(*status);
}

/// The drives first.
void PortOutput::rest() noexcept {
  registers_->write_control(pins_.rest().control);
  registers_->write_data(pins_.rest().data);
  word_ = pins_.rest();
  last_ = word_;
}

Diagnostic PortOutput::diagnostic(Alarm alarm) const {
  const auto disabled = [this](Code code, const char* text) {
    return Diagnostic{
        .code = code, .message = std::string(text) + "; the drives are disabled", .file = device_};
  };
  switch (alarm) {
    case Alarm::emergency_stop:
      return disabled(Code::SC5031, "emergency stop: the input of backend.parport.estop_pin is on");
    case Alarm::limit_switch:
      return disabled(Code::SC5032,
                      "an axis is on a limit switch: the input of "
                      "backend.parport.limit_pin is on");
    case Alarm::driver_fault:
      return disabled(Code::SC5033,
                      "a drive reports a fault: the input of backend.parport.fault_pin "
                      "is on");
    case Alarm::overrun:
      return disabled(Code::SC5030, "the port was not written to for a whole period");
    default:
      return registers_->failure();
  }
}

}  // namespace softcnc::hal
