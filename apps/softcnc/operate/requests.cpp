// SPDX-License-Identifier: MIT
#include "operate/requests.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/session/feed_script.hpp"

namespace softcnc::app {

/// What is wrong with lines comes to the journal while the machine takes them: after this.
void Requests::begin(std::string_view what) {
  journal_.add(EntryKind::action, what);
  machine_.note_change();
}

bool Requests::end(const Status& answer) {
  if (!answer) journal_.add(answer.error());
  return answer.has_value();
}

bool Requests::request(std::string_view what, Status (runtime::Operator::*act)()) {
  begin(what);
  return end((control().*act)());
}

bool Requests::jog(const runtime::Jog& jog, const std::string& what) {
  begin("jog " + what);
  return end(control().jog(jog));
}

bool Requests::line(const std::string& text) {
  begin(text);
  return end(control().line(text + '\n'));
}

bool Requests::start(const LoadedProgram& program) {
  begin("start " + program.name());
  return end(control().start(program.text(), program.folder()));
}

/// Axes that are not named stay where they are thought to be.
bool Requests::stand_at(const AxisWords& place, const std::string& text) {
  AxisVector to = control().position();
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    if (place.mm[axis]) to[static_cast<Eigen::Index>(axis)] = *place.mm[axis];
  begin("the machine stands at " + text);
  return end(control().set_position(to));
}

bool Requests::touch_off(const AxisWords& place, const std::string& text) {
  begin("touch off " + text);
  Status taken;
  for (int axis = 0; axis < kAxes && taken; ++axis)
    if (const auto mm = place.mm[static_cast<std::size_t>(axis)])
      taken = control().touch_off(axis, *mm);
  return end(taken);
}

void Requests::estop() {
  begin("emergency stop");
  control().estop();
}

void Requests::override_feed(double wanted) {
  overrides_.feed = std::clamp(wanted, runtime::kLeastOfOperator, runtime::kLargestOverride);
  control().set_feed_override(overrides_.feed);
  begin(fmt::format("feed {:.0f} %", 100 * overrides_.feed));
}

void Requests::override_rapid(double wanted) {
  overrides_.rapid = std::clamp(wanted, runtime::kSmallestRapid, runtime::kLargestRapid);
  control().set_rapid_override(overrides_.rapid);
  begin(fmt::format("rapids {:.0f} %", 100 * overrides_.rapid));
}

void Requests::override_spindle(double wanted) {
  overrides_.spindle = std::clamp(wanted, runtime::kLeastOfOperator, runtime::kLargestOverride);
  control().set_spindle_override(overrides_.spindle);
  begin(fmt::format("spindle {:.0f} %", 100 * overrides_.spindle));
}

void Requests::set(const Switches& wanted) {
  const auto change = [&](const char* what, bool before, bool now) {
    if (before != now) begin(fmt::format("{} {}", what, now ? "on" : "off"));
  };
  const Switches before = std::exchange(switches_, wanted);
  control().set_single_block(wanted.single_block);
  control().set_optional_stop(wanted.optional_stop);
  control().set_block_skip(wanted.block_skip);
  change("single block", before.single_block, wanted.single_block);
  change("optional stop", before.optional_stop, wanted.optional_stop);
  change("block skip", before.block_skip, wanted.block_skip);
}

}  // namespace softcnc::app
