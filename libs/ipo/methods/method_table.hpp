// SPDX-License-Identifier: MIT
// The table of methods: source, what each ignores, and its rule.
#pragma once

#include <span>
#include <string_view>

#include "ipo/methods/step_rule.hpp"
#include "motion/model/method.hpp"

namespace softcnc::ipo {

/// A row of the table.
struct MethodEntry {
  Method method;
  std::string_view source;   // as docs/methods.md names it
  std::string_view ignores;  // of what a run promises, likewise; empty: nothing
  StepRule rule{};           // of a method that steps along the parameter of a curve
};

/// Returns a row for each method, in the order of the enumeration.
std::span<const MethodEntry> method_table() noexcept;

/// Realtime.
inline const MethodEntry& entry_of(Method method) noexcept {
  return method_table()[static_cast<std::size_t>(method)];
}

}  // namespace softcnc::ipo
