// SPDX-License-Identifier: MIT
#include "settings/machine_choice.hpp"

#include <sys/stat.h>

#include <utility>

#include "hal/machine/machine_confinement.hpp"
#include "settings/file_clash.hpp"

namespace softcnc::app {
namespace {

/// A file that somebody has put there without a thought of this run. What is no regular file loses
/// nothing by being written to.
bool blocks_default(const std::string& file) {
  struct stat info {};
  return ::lstat(file.c_str(), &info) == 0 && (S_ISREG(info.st_mode) || S_ISLNK(info.st_mode));
}

/// Only these commands let the backend write.
bool writes(const Options& options) {
  return !options.dry_run &&
         (options.command == CommandName::run || options.command == CommandName::record ||
          options.command == CommandName::operate || options.command == CommandName::serve);
}

Status check_default_file(const hal::FoundMachine& found, const Options& options) {
  if (!found.default_file || !writes(options)) return {};
  const auto [key, file] = backend_file(found.machine);
  if (!blocks_default(file)) return {};
  return tl::make_unexpected(
      Diagnostic{.code = Code::SC6015,
                 .message = "exists already, and you have not named it: name a file with --set " +
                            key + "=FILE; the file " + file + " is left unchanged",
                 .file = file});
}

}  // namespace

std::string machine_beside(const std::string& part, const Options& options) {
  if (part == "-") return {};
  std::string file = hal::machine_beside(part);
  if (same_file(file, part) || same_file(file, options.state)) return {};
  return file;
}

hal::MachineSource machine_source(const std::string& part, const Options& options) {
  if (options.names_machine) return {options.machine_file, false};
  std::string beside = machine_beside(part, options);
  const bool found = !beside.empty();
  return {std::move(beside), found};
}

Result<MachineChoice> choose_machine(const std::string& part, const Options& options,
                                     Messages& messages) {
  const hal::MachineSource source = machine_source(part, options);
  auto found = hal::find_machine(source, options.settings);
  if (!found) return tl::make_unexpected(messages.show_but_last(std::move(found.error())));
  for (const Diagnostic& warning : found->ignored) messages.show(warning);
  if (Status free = check_default_file(*found, options); !free)
    return tl::make_unexpected(std::move(free.error()));
  return MachineChoice{std::move(found->machine), source.confined ? source.file : std::string()};
}

const Machine* MachineCache::of(const hal::MachineSource& source) {
  auto known = machines_.find(source.file);
  if (known == machines_.end()) known = machines_.emplace(source.file, load(source)).first;
  return known->second ? &*known->second : nullptr;
}

/// A setting that no machine takes is wrong once, however many machines there are.
std::optional<Machine> MachineCache::load(const hal::MachineSource& source) {
  auto found = hal::find_machine(source, options_.settings);
  if (found) {
    for (const Diagnostic& warning : found->ignored) messages_.show(warning);
    return std::move(found->machine);
  }
  for (Diagnostic& error : found.error()) {
    status_ = worse_status(status_, exit_status(error));
    const bool is_of_file = error.file == source.file;
    if (is_of_file || reported_.insert(error.message).second) messages_.fail(std::move(error));
  }
  return std::nullopt;
}

}  // namespace softcnc::app
