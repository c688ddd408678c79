// SPDX-License-Identifier: MIT
#include "hal/backends/stream_rows.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kMostDigital = 64;
constexpr std::size_t kRowLength = (kAxes + 3) * (kNumberLength + 1) + 2 * (kMostDigital + 2);

/// In the order of their numbers.
std::vector<StreamedOutput> streamed_outputs(const Machine& machine) {
  std::vector<StreamedOutput> outputs;
  if (!machine.hal_stream.outputs) return outputs;
  for (const auto& [name, port] : machine.outputs)
    if (is_switched(port)) outputs.push_back({port.number, name});
  std::sort(outputs.begin(), outputs.end(),
            [](const auto& a, const auto& b) { return a.number < b.number; });
  return outputs;
}

char* write_bit(char* end, bool bit) noexcept {
  *end++ = ' ';
  *end++ = bit ? '1' : '0';
  return end;
}

}  // namespace

std::string stream_config(const Machine& machine) {
  std::string config;
  for (const Axis& axis : machine.axes)
    if (axis.present) config += 'f';
  config += "bu";
  if (machine.hal_stream.outputs)
    config += "fbb" + std::string(streamed_outputs(machine).size(), 'b');
  return config;
}

StreamRows::StreamRows(const Machine& machine, std::size_t lead)
    : period_(number_text(ms_from_s(fine_period(machine.control)))),
      config_(stream_config(machine)),
      digital_(streamed_outputs(machine)),
      streams_outputs_(machine.hal_stream.outputs),
      parts_(parts_of_period(machine.control, fine_period(machine.control))) {
  for (int axis = 0; axis < kAxes; ++axis)
    if (machine.axes[static_cast<std::size_t>(axis)].present) axes_.push_back(axis);
  bytes_.reserve(lead + static_cast<std::size_t>(parts_) * kRowLength);
}

std::string StreamRows::head() const {
  std::string text =
      "# softcnc rows 1 for halstreamer, one every " + period_ + " ms\n# cfg=" + config_ + ':';
  for (const int axis : axes_) text += ' ' + axis_name(axis) + "_mm";
  text += " runs row";
  if (streams_outputs_) text += " spindle_rpm mist flood";
  for (const StreamedOutput& output : digital_) text += ' ' + output.name;
  return text + '\n';
}

std::string StreamRows::tail() const {
  return "# " + std::to_string(rows_) + " rows, xxh3 " + checksum() + '\n';
}

/// What is switched counts from the row of the setpoint on.
void StreamRows::add(const Setpoint& setpoint) noexcept {
  int left = std::exchange(started_, true) ? parts_ : 1;
  for_instants(setpoint, last_, left, [&](const FinePoint& point) {
    if (--left == 0) outputs_ = setpoint.outputs;
    row(point.position, true);
  });
  last_ = {setpoint.s, setpoint.position};
}

void StreamRows::rest() noexcept {
  if (started_) row(last_.position, false);
}

void StreamRows::row(const AxisVector& position, bool runs) noexcept {
  char text[kRowLength];
  char* end = text;
  for (const int axis : axes_) {
    end = write_number(end, position[axis]);
    *end++ = ' ';
  }
  *end++ = runs ? '1' : '0';
  *end++ = ' ';
  end = std::to_chars(end, text + kRowLength, ++rows_).ptr;
  if (streams_outputs_) end = write_outputs(end);
  *end++ = '\n';
  bytes_.append(text, end);
}

char* StreamRows::write_outputs(char* end) const noexcept {
  *end++ = ' ';
  end = write_number(end, outputs_.spindle_rpm);
  end = write_bit(end, outputs_.mist);
  end = write_bit(end, outputs_.flood);
  for (const StreamedOutput& output : digital_) end = write_bit(end, outputs_.is_on(output.number));
  return end;
}

void StreamRows::pass() noexcept {
  hasher_.add(bytes_);
  bytes_.clear();
}

}  // namespace softcnc::hal
