// SPDX-License-Identifier: MIT
#include "machine_memory.hpp"

#include <filesystem>
#include <utility>
#include <vector>

#include "hal/state_file.hpp"

namespace softcnc::app {

namespace {

/// The last fault; those before it are shown.
Diagnostic last_of(std::vector<Diagnostic>&& faults, Messages& messages) {
  Diagnostic last = std::move(faults.back());
  faults.pop_back();
  for (const Diagnostic& fault : faults) messages.show(fault);
  return last;
}

}  // namespace

Result<MachineState> open_state(const std::string& file, Messages& messages) {
  std::error_code ignored;
  if (file.empty()) return MachineState();
  if (std::filesystem::exists(file, ignored) || ignored) {
    return hal::load_state(file).map_error(
        [&](std::vector<Diagnostic>&& faults) { return last_of(std::move(faults), messages); });
  }
  messages.show({Code::SC7017,
                 {},
                 "is not there yet: work offsets, tool table and parameters begin at 0",
                 file,
                 {}});
  return MachineState();
}

Result<MachineMemory> MachineMemory::open(const std::string& file, MachineState before) {
  if (file.empty()) return MachineMemory(nullptr, std::move(before));
  auto output = hal::OutputFile::open(file);
  if (!output) return tl::make_unexpected(std::move(output.error()));
  return MachineMemory(std::move(*output), std::move(before));
}

Status MachineMemory::keep(const MachineState& state) {
  const std::string text = hal::state_toml(state);
  if (!file_ || text == hal::state_toml(before_)) return {};
  if (Status written = file_->write(text); !written) return written;
  return file_->finish();
}

}  // namespace softcnc::app
