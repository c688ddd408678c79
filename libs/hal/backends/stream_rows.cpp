// SPDX-License-Identifier: MIT
#include "hal/backends/stream_rows.hpp"

#include <charconv>
#include <utility>

#include "hal/files/axis_name.hpp"
#include "hal/files/number.hpp"
#include "motion/core/units.hpp"

namespace softcnc::hal {
namespace {

constexpr std::size_t kRowLength = (kAxes + 2) * (kNumberLength + 1);

}  // namespace

std::string stream_config(const Machine& machine) {
  std::string config;
  for (const Axis& axis : machine.axes)
    if (axis.present) config += 'f';
  return config + "bu";
}

StreamRows::StreamRows(const Machine& machine, std::size_t lead)
    : period_(number_text(ms_from_s(fine_period(machine.control)))),
      config_(stream_config(machine)),
      parts_(parts_of_period(machine.control, fine_period(machine.control))) {
  for (int axis = 0; axis < kAxes; ++axis)
    if (machine.axes[static_cast<std::size_t>(axis)].present) axes_.push_back(axis);
  bytes_.reserve(lead + static_cast<std::size_t>(parts_) * kRowLength);
}

std::string StreamRows::head() const {
  std::string text =
      "# softcnc rows 1 for halstreamer, one every " + period_ + " ms\n# cfg=" + config_ + ':';
  for (const int axis : axes_) text += ' ' + axis_name(axis) + "_mm";
  return text + " runs row\n";
}

std::string StreamRows::tail() const {
  return "# " + std::to_string(rows_) + " rows, xxh3 " + checksum() + '\n';
}

void StreamRows::add(const Setpoint& setpoint) noexcept {
  for_instants(setpoint, last_, std::exchange(started_, true) ? parts_ : 1,
               [this](const FinePoint& point) { row(point.position, true); });
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
  *end++ = '\n';
  bytes_.append(text, end);
}

void StreamRows::pass() noexcept {
  hasher_.add(bytes_);
  bytes_.clear();
}

}  // namespace softcnc::hal
