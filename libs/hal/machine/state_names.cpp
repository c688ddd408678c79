// SPDX-License-Identifier: MIT
// Names into indices and back.
#include "hal/machine/state_names.hpp"

#include <charconv>
#include <system_error>

namespace softcnc::hal {
namespace {

constexpr const char* kFurther = "G54.1 P";  // followed by the number of the system

}  // namespace

std::optional<int> number_of(std::string_view word) {
  int number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = error == std::errc{} && end == word.data() + word.size() && word[0] != '0';
  return whole && number > 0 ? std::optional(number) : std::nullopt;
}

std::string_view without(std::string_view text, std::string_view prefix) {
  return text.starts_with(prefix) ? text.substr(prefix.size()) : std::string_view();
}

std::optional<int> system_index(std::string_view name) {
  if (const auto index = index_in(kWorkNames, name)) return index;
  const std::string_view number = without(name, kFurther);
  const auto further = number.empty() ? std::nullopt : number_of(number);
  if (!further || *further > kFurtherSystems) return std::nullopt;
  return kWorkSystems + *further - 1;
}

std::string system_name(int index) {
  if (index >= kWorkSystems) return kFurther + std::to_string(index - kWorkSystems + 1);
  return std::string(kWorkNames[static_cast<std::size_t>(index)]);
}

}  // namespace softcnc::hal
