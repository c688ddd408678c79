// SPDX-License-Identifier: MIT
#include "settings/machine_memory.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "hal/machine/state_file.hpp"

namespace softcnc::app {

Result<MachineState> open_state(const std::string& file, Messages& messages) {
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

Result<MachineMemory> MachineMemory::open(const std::string& file, MachineState before) {
  if (file.empty()) return MachineMemory(nullptr, std::move(before));
  auto output = hal::OutputFile::open(file);
  if (!output) return tl::make_unexpected(std::move(output.error()));
  return MachineMemory(std::move(*output), std::move(before));
}

Result<bool> MachineMemory::keep(const MachineState& state) {
  const std::string text = hal::state_toml(state);
  if (!file_ || text == hal::state_toml(before_)) return false;
  Status written = file_->write(text);
  if (written) written = file_->finish();
  if (!written) return tl::make_unexpected(std::move(written.error()));
  return true;
}

}  // namespace softcnc::app
