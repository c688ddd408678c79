// SPDX-License-Identifier: MIT
#include "settings/machine_memory.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <utility>
#include <vector>

#include "hal/machine/state_file.hpp"
#include "hal/machine/state_names.hpp"
#include "runtime/operator/position_status.hpp"

namespace softcnc::app {

namespace {

Result<MachineState> read_state(const std::string& file, Messages& messages) {
  std::error_code ignored;
  if (file.empty()) return MachineState();
  if (std::filesystem::exists(file, ignored) || ignored) {
    return hal::load_state(file).map_error([&](std::vector<Diagnostic>&& errors) {
      return messages.show_but_last(std::move(errors));
    });
  }
  messages.show(
      {.code = Code::SC7017,
       .message = "does not exist yet: work offsets, tool table and parameters begin at 0",
       .file = file});
  return MachineState();
}

}  // namespace

std::optional<int> parse_work_system(std::string_view word) {
  std::string name;
  for (const char c : word) {
    if (c == ' ') continue;
    const char letter = c == 'g' || c == 'p' ? static_cast<char>(c - 'a' + 'A') : c;
    if (letter == 'P') name += ' ';
    name += letter;
  }
  return hal::system_index(name);
}

std::optional<double> parse_mm(std::string_view text) {
  double mm = 0;
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), mm);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && is_near(mm) ? std::optional(mm) : std::nullopt;
}

std::optional<WorkOrigin> parse_work_origin(std::string_view text) {
  const std::size_t sign = text.find('=');
  const auto system = parse_work_system(text.substr(0, sign));
  if (sign == std::string_view::npos || !system) return std::nullopt;
  WorkOrigin work{*system, {}};
  std::string_view rest = text.substr(sign + 1);
  for (std::optional<double>& axis : work.origin) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string_view number = rest.substr(0, comma);
    if (!number.empty() && !(axis = parse_mm(number))) return std::nullopt;
    if (comma == rest.size()) return text.back() == '=' ? std::nullopt : std::optional(work);
    rest.remove_prefix(comma + 1);
  }
  return std::nullopt;
}

Result<MachineState> open_state(const Options& options, Messages& messages) {
  auto state = read_state(options.state, messages);
  if (!state) return state;
  for (const WorkOrigin& work : options.work)
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      if (work.origin[axis])
        state->work_system_entry(work.system).origin[static_cast<Eigen::Index>(axis)] =
            *work.origin[axis];
  const bool is_told = options.command == CommandName::state ||
                       options.command == CommandName::operate ||
                       options.command == CommandName::serve ||
                       (options.command == CommandName::run && !options.dry_run);
  if (const auto warning = runtime::position_warning(*state, options.state); warning && !is_told)
    messages.show(*warning);
  return state;
}

bool keeps_state(const Options& options, const Machine& machine) {
  if (options.state.empty() || options.dry_run) return false;
  return options.command == CommandName::run ||
         (options.command == CommandName::record && moves_machine(machine.control.backend));
}

Result<MachineMemory> MachineMemory::open(const std::string& file) {
  auto lock = hal::FileLock::take(file);
  if (!lock) return tl::make_unexpected(std::move(lock.error()));
  auto output = hal::OutputFile::open(file);
  if (!output) return tl::make_unexpected(std::move(output.error()));
  return MachineMemory(file, std::move(*lock), std::move(*output));
}

Status MachineMemory::mark_motion(MachineState before) {
  if (name_.empty()) return {};
  before.position = KeptPosition{before.place(), true};
  in_file_.reset();
  return hal::write_file(name_, hal::state_toml(before));
}

/// The first time into the file that was opened before anything moved.
Status MachineMemory::write(const std::string& text) {
  if (!file_) return hal::write_file(name_, text);
  Status written = file_->write(text);
  if (written) written = file_->finish();
  file_.reset();
  return written;
}

Result<bool> MachineMemory::keep(const MachineState& state) {
  const std::string text = hal::state_toml(state);
  if (name_.empty() || (in_file_ && text == hal::state_toml(*in_file_))) return false;
  Status written = write(text);
  if (!written) return tl::make_unexpected(std::move(written.error()));
  in_file_ = state;
  return true;
}

}  // namespace softcnc::app
