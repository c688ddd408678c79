// SPDX-License-Identifier: MIT
#include "input/reported_run.hpp"

#include <algorithm>
#include <string_view>

namespace softcnc::app {
namespace {

bool has_suffix(std::string_view file, std::string_view suffix) {
  return file.ends_with(suffix) || file.ends_with(std::string(suffix) + ".zst");
}

}  // namespace

InputKind input_kind(const std::string& file) {
  if (file.ends_with(".rec")) return InputKind::recording;
  if (has_suffix(file, ".csv") || has_suffix(file, ".npz")) return InputKind::trace;
  return InputKind::program;
}

bool names_machine(std::string_view compared) noexcept {
  return compared.ends_with(".toml") || compared == "builtin";
}

std::string_view name(InputKind kind) noexcept {
  constexpr std::array<std::string_view, 3> names{"program", "trace", "recording"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<runtime::LineTime> worst_lines(const ReportedRun& run, std::size_t count) {
  constexpr double kLeast = 1e-4;  // s: less is not worth a look
  std::vector<runtime::LineTime> lines;
  std::copy_if(run.lines.begin(), run.lines.end(), std::back_inserter(lines),
               [](const runtime::LineTime& line) { return line.lost > kLeast; });
  const auto worse = [](const runtime::LineTime& a, const runtime::LineTime& b) {
    return a.lost > b.lost;
  };
  std::stable_sort(lines.begin(), lines.end(), worse);
  lines.resize(std::min(lines.size(), count));
  return lines;
}

}  // namespace softcnc::app
