// SPDX-License-Identifier: MIT
#include "settings/file_clash.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <span>
#include <vector>

#include "hal/files/output_file.hpp"
#include "settings/machine_choice.hpp"
#include "settings/machine_memory.hpp"

namespace softcnc::app {
namespace {

struct NamedFile {
  std::string role;
  std::string name;
};

std::filesystem::path absolute(const std::string& name) {
  std::error_code error;
  auto path = std::filesystem::weakly_canonical(
      std::filesystem::absolute(hal::target_of(name), error), error);
  return error ? std::filesystem::path(name) : path;
}

std::string clash(const Options& options, std::span<const NamedFile> written) {
  std::vector<NamedFile> others{{"--machine", options.machine_file}};
  for (const std::string& file : options.machine_files) others.push_back({"--machine", file});
  others.push_back({"--compare", options.compared});
  others.push_back({"FILE", options.imported});
  for (const std::string& file : options.files)
    if (file != "-") others.push_back({"PART", file});
  for (const std::string& file : options.files)
    others.push_back({"the machine file of PART", machine_source(file, options).file});
  for (const NamedFile& file : written) {
    for (const NamedFile& other : others)
      if (same_file(file.name, other.name))
        return fmt::format("{} and {} name the same file: {}", other.role, file.role, file.name);
    others.push_back(file);
  }
  return {};
}

std::vector<NamedFile> written_by(const Options& options) {
  return {{"--state", options.state},   {"--trace", options.trace},   {"--log", options.log},
          {"--report", options.report}, {"--output", options.output}, {"--junit", options.junit}};
}

NamedFile written_by(const Machine& machine) {
  const auto [key, file] = backend_file(machine);
  return {key, file};
}

}  // namespace

bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  if (a == "-" || b == "-") return a == b;
  struct stat info_a {
  }, info_b{};
  const bool a_exists = ::stat(a.c_str(), &info_a) == 0;
  const bool b_exists = ::stat(b.c_str(), &info_b) == 0;
  if (!a_exists && !b_exists) return absolute(a) == absolute(b);
  return a_exists && b_exists && S_ISREG(info_a.st_mode) && info_a.st_dev == info_b.st_dev &&
         info_a.st_ino == info_b.st_ino;
}

std::pair<std::string, std::string> backend_file(const Machine& machine) {
  const BackendKind backend = machine.control.backend;
  if (backend == BackendKind::stepdir) return {"backend.stepdir.file", machine.step_port.file};
  if (backend == BackendKind::hal_stream)
    return {"backend.hal-stream.file", machine.hal_stream.file};
  return {};
}

std::string file_clash(const Options& options) { return clash(options, written_by(options)); }

std::string file_clash(const Options& options, const Machine& machine) {
  auto written = written_by(options);
  written.push_back(written_by(machine));
  return clash(options, written);
}

std::vector<std::string> written_files(const Options& options, const Machine& machine) {
  return {options.trace, options.report, options.output,
          keeps_state(options, machine) ? options.state : "", written_by(machine).name};
}

}  // namespace softcnc::app
